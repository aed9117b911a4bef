#include "kernel/image/components.h"

#include <cassert>

#include "kernel/base/disjoint_sets.h"
#include "kernel/image/image_size.h"

namespace relievo {
namespace {

/// Labels the pixel from those of its neighbours before it, uniting them where they differ.
int32_t label_of(const Image<int32_t>& label, int x, int y, Connectivity connectivity,
                 DisjointSets& sets) {
  int32_t found = 0;
  const auto join = [&](int nx, int ny) {
    if (nx < 0 || ny < 0 || nx >= label.width) return;
    const int32_t other = label.at(nx, ny);
    if (other == 0 || other == found) return;
    if (found != 0) sets.unite(found, other);
    found = other;
  };
  join(x - 1, y);
  join(x, y - 1);
  if (connectivity == Connectivity::corners) {
    join(x - 1, y - 1);
    join(x + 1, y - 1);
  }
  return found != 0 ? found : sets.add();
}

/// Numbers the sets but the first without gaps, in the order of their smallest members.
std::vector<int32_t> number(DisjointSets& sets, int32_t& count) {
  std::vector<int32_t> numbers(sets.size(), 0);
  count = 0;
  for (int i = 1; i < sets.size(); ++i)
    numbers[i] = sets.find(i) == i ? ++count : numbers[sets.find(i)];
  return numbers;
}

}  // namespace

Components connected_components(const Image8& mask, Connectivity connectivity) {
  assert(mask.channels == 1);
  Components result{Image<int32_t>(mask.width, mask.height, 1), {}};
  DisjointSets sets(1);
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if (mask.at(x, y) != 0)
        result.label.at(x, y) = label_of(result.label, x, y, connectivity, sets);
  int32_t count = 0;
  const std::vector<int32_t> numbers = number(sets, count);
  result.areas.assign(static_cast<size_t>(count) + 1, 0);
  for (int32_t& label : result.label.pixels) ++result.areas[label = numbers[label]];
  return result;
}

Mask connected_to(const Mask& mask, const Mask& seed) {
  const Components pieces = connected_components(mask.inside, Connectivity::sides);
  std::vector<uint8_t> reached(pieces.areas.size(), 0);
  for_each_pixel(seed, [&](int x, int y) {
    if (mask.has(x, y)) reached[pieces.label.at(x - mask.left, y - mask.top)] = 1;
  });
  Mask result = mask;
  for (size_t i = 0; i < pieces.label.pixels.size(); ++i)
    result.inside.pixels[i] = reached[pieces.label.pixels[i]];
  return result;
}

std::vector<uint8_t> pieces_at_edge(const Components& pieces) {
  std::vector<uint8_t> reaches(pieces.areas.size(), 0);
  along_edge(pieces.label.width, pieces.label.height,
             [&](int x, int y) { reaches[pieces.label.at(x, y)] = 1; });
  reaches[0] = 0;
  return reaches;
}

}  // namespace relievo

#include "kernel/image/components.h"

#include <algorithm>
#include <cassert>

#include "kernel/base/disjoint_sets.h"
#include "kernel/image/image_size.h"

namespace relievo {
namespace {

/// Pixels of a row that follow each other in the mask.
struct Run {
  int32_t begin = 0;
  int32_t end = 0;  ///< one past the last
  int32_t label = 0;
};

/// The runs of all rows; those of row y are from row[y] to before row[y + 1].
struct Runs {
  std::vector<Run> runs;
  std::vector<size_t> row;
};

Runs find_runs(const Image8& mask) {
  Runs found;
  for (int y = 0; y < mask.height; ++y) {
    found.row.push_back(found.runs.size());
    const uint8_t* row = mask.pixels.data() + static_cast<size_t>(y) * mask.width;
    for (int x = 0; x < mask.width; ++x) {
      if (row[x] == 0) continue;
      const int begin = x;
      while (x < mask.width && row[x] != 0) ++x;
      found.runs.push_back({begin, x, 0});
    }
  }
  found.row.push_back(found.runs.size());
  return found;
}

/// Labels the runs of a row from those of the row above that are no farther than `reach` beside
/// them, uniting labels where several are.
void label_row(Runs& found, int y, int reach, DisjointSets& sets) {
  size_t first = y > 0 ? found.row[y - 1] : found.row[y];
  const size_t end = found.row[y];
  for (size_t i = found.row[y]; i < found.row[y + 1]; ++i) {
    Run& run = found.runs[i];
    while (first < end && found.runs[first].end + reach <= run.begin) ++first;
    for (size_t k = first; k < end && found.runs[k].begin < run.end + reach; ++k) {
      const int32_t above = found.runs[k].label;
      if (run.label != 0 && run.label != above) sets.unite(run.label, above);
      run.label = above;
    }
    if (run.label == 0) run.label = sets.add();
  }
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
  Runs found = find_runs(mask);
  DisjointSets sets(1);
  for (int y = 0; y < mask.height; ++y)
    label_row(found, y, connectivity == Connectivity::corners ? 1 : 0, sets);
  int32_t count = 0;
  const std::vector<int32_t> numbers = number(sets, count);
  Components result{Image<int32_t>(mask.width, mask.height, 1), {}};
  result.areas.assign(static_cast<size_t>(count) + 1, 0);
  result.areas[0] = static_cast<int64_t>(mask.pixels.size());
  for (int y = 0; y < mask.height; ++y) {
    int32_t* row = result.label.pixels.data() + static_cast<size_t>(y) * mask.width;
    for (size_t i = found.row[y]; i < found.row[y + 1]; ++i) {
      const Run& run = found.runs[i];
      const int32_t label = numbers[run.label];
      std::fill(row + run.begin, row + run.end, label);
      result.areas[label] += run.end - run.begin;
      result.areas[0] -= run.end - run.begin;
    }
  }
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

Image8 hysteresis_threshold(const Image8& values, int low, int high) {
  const int w = values.width;
  Image8 result(w, values.height, 1);
  std::vector<int> open;
  const auto take = [&](int i) {
    result.pixels[i] = 1;
    open.push_back(i);
  };
  const auto count = static_cast<int>(values.pixels.size());
  for (int i = 0; i < count; ++i)
    if (values.pixels[i] >= high) take(i);
  while (!open.empty()) {
    const int i = open.back();
    open.pop_back();
    const int x = i % w;
    const int y = i / w;
    for (int v = std::max(0, y - 1); v <= std::min(values.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(w - 1, x + 1); ++u)
        if (result.at(u, v) == 0 && values.at(u, v) >= low) take(v * w + u);
  }
  return result;
}

}  // namespace relievo

#include "kernel/image/components.h"

#include <algorithm>
#include <cassert>

#include "kernel/base/disjoint_sets.h"
#include "kernel/image/image_size.h"
#include "kernel/image/morphology.h"
#include "kernel/image/outlines.h"

namespace relievo {
namespace {

constexpr double piece_share = 0.03;  ///< least area of a piece over that of the largest

/// A run of consecutive pixels of the mask in a row.
struct Run {
  int32_t begin = 0;
  int32_t end = 0;  ///< one past the last
  int32_t label = 0;
};

/// Lists the runs of all rows. Writes `row_begin`, empty at first: the runs of row y are
/// [row_begin[y], row_begin[y + 1]).
std::vector<Run> find_runs(const Image8& mask, std::vector<size_t>& row_begin) {
  std::vector<Run> runs;
  for (int y = 0; y < mask.height; ++y) {
    row_begin.push_back(runs.size());
    const uint8_t* row = mask.pixels.data() + static_cast<size_t>(y) * mask.width;
    for (int x = 0; x < mask.width; ++x) {
      if (row[x] == 0) continue;
      const int begin = x;
      while (x < mask.width && row[x] != 0) ++x;
      runs.push_back({begin, x, 0});
    }
  }
  row_begin.push_back(runs.size());
  return runs;
}

/// Labels the runs [begin, end) of a row. Each takes the label of the runs [first, begin) of the
/// row above that it touches, or, with a `reach` of 1, touches at a corner; several labels are
/// united.
void label_row(std::vector<Run>& runs, size_t first, size_t begin, size_t end, int reach,
               DisjointSets& sets) {
  for (size_t i = begin; i < end; ++i) {
    Run& run = runs[i];
    while (first < begin && runs[first].end + reach <= run.begin) ++first;
    for (size_t k = first; k < begin && runs[k].begin < run.end + reach; ++k) {
      const int32_t above = runs[k].label;
      if (run.label != 0 && run.label != above) sets.unite(run.label, above);
      run.label = above;
    }
    if (run.label == 0) run.label = sets.add();
  }
}

/// Numbers all sets but the first consecutively from 1, in the order of their smallest members.
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
  std::vector<size_t> begin;
  std::vector<Run> runs = find_runs(mask, begin);
  DisjointSets sets(1);
  const int reach = connectivity == Connectivity::corners ? 1 : 0;
  for (int y = 0; y < mask.height; ++y)
    label_row(runs, begin[std::max(y - 1, 0)], begin[y], begin[y + 1], reach, sets);
  int32_t count = 0;
  const std::vector<int32_t> numbers = number(sets, count);
  Components result{Image<int32_t>(mask.width, mask.height, 1), {}};
  result.areas.assign(static_cast<size_t>(count) + 1, 0);
  result.areas[0] = static_cast<int64_t>(mask.pixels.size());
  for (int y = 0; y < mask.height; ++y) {
    int32_t* row = result.label.pixels.data() + static_cast<size_t>(y) * mask.width;
    for (size_t i = begin[y]; i < begin[y + 1]; ++i) {
      const Run& run = runs[i];
      const int32_t label = numbers[run.label];
      std::fill(row + run.begin, row + run.end, label);
      result.areas[label] += run.end - run.begin;
      result.areas[0] -= run.end - run.begin;
    }
  }
  return result;
}

Image8 mask_of_pieces(const Components& pieces, const std::vector<uint8_t>& chosen) {
  return mask_where(pieces.label.width, pieces.label.height,
                    [&](size_t i) { return chosen[pieces.label.pixels[i]] != 0; });
}

std::vector<uint8_t> pieces_at_edge(const Components& pieces) {
  std::vector<uint8_t> reaches(pieces.areas.size(), 0);
  along_edge(pieces.label.width, pieces.label.height,
             [&](int x, int y) { reaches[pieces.label.at(x, y)] = 1; });
  reaches[0] = 0;
  return reaches;
}

Mask connected_to(const Mask& mask, const Mask& seed) {
  const Components pieces = connected_components(mask.inside, Connectivity::sides);
  std::vector<uint8_t> reached(pieces.areas.size(), 0);
  for_each_pixel(seed, [&](int x, int y) {
    if (mask.has(x, y)) reached[pieces.label.at(x - mask.left, y - mask.top)] = 1;
  });
  return {mask.left, mask.top, mask_of_pieces(pieces, reached)};
}

Image8 hysteresis_threshold(const Image8& values, int low, int high) {
  const Image8 possible =
      mask_where(values.width, values.height, [&](size_t i) { return values.pixels[i] >= low; });
  const Components pieces = connected_components(possible, Connectivity::corners);
  std::vector<uint8_t> sure(pieces.areas.size(), 0);
  for (size_t i = 0; i < values.pixels.size(); ++i)
    if (values.pixels[i] >= high) sure[pieces.label.pixels[i]] = 1;
  return mask_of_pieces(pieces, sure);
}

double share_of_box(const Image8& mask) {
  const Box2 box = box_of(mask);
  if (box.empty()) return 0;
  return static_cast<double>(pixel_count(mask)) /
         ((box.max.x - box.min.x) * (box.max.y - box.min.y));
}

Image8 without_small_pieces(const Image8& mask) {
  const Components pieces = connected_components(mask, Connectivity::corners);
  if (pieces.areas.size() < 2) return mask;
  const auto largest =
      static_cast<double>(*std::max_element(pieces.areas.begin() + 1, pieces.areas.end()));
  std::vector<uint8_t> large(pieces.areas.size(), 0);
  for (size_t k = 1; k < large.size(); ++k)
    large[k] = static_cast<double>(pieces.areas[k]) >= piece_share * largest;
  return mask_of_pieces(pieces, large);
}

Image8 without_holes(const Image8& mask) {
  const Components outside = connected_components(complement(mask), Connectivity::sides);
  return complement(mask_of_pieces(outside, pieces_at_edge(outside)));
}

}  // namespace relievo

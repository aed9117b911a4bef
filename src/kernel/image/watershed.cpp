#include "kernel/image/watershed.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "kernel/base/disjoint_sets.h"

namespace relievo {
namespace {

/// Calls visit(index) for each of the up to four pixels that share a side with pixel i.
template <class Visit>
void for_sides(int32_t i, int width, int height, const Visit& visit) {
  const int y = static_cast<int>(static_cast<uint32_t>(i) / static_cast<uint32_t>(width));
  const int x = i - y * width;
  if (y > 0) visit(i - width);
  if (x > 0) visit(i - 1);
  if (x + 1 < width) visit(i + 1);
  if (y + 1 < height) visit(i + width);
}

/// First-in-first-out queues of pixels, one per height; the lowest is served first. A pixel pushed
/// below the height being served joins the queue of that height.
class HeightQueues {
 public:
  void push(uint8_t height, int32_t pixel) {
    queues_[std::max<size_t>(height, level_)].push_back(pixel);
  }

  /// Returns the next pixel, or -1 when there is none.
  int32_t pop() {
    while (next_ == queues_[level_].size()) {
      queues_[level_] = {};
      next_ = 0;
      if (++level_ == queues_.size()) return -1;
    }
    return queues_[level_][next_++];
  }

 private:
  std::array<std::vector<int32_t>, 256> queues_;
  size_t level_ = 0;
  size_t next_ = 0;
};

/// Lists the pixels of seeds that share a side with a pixel of value 0.
std::vector<int32_t> seeds_beside_open(const Image<int32_t>& label) {
  const int w = label.width;
  std::vector<int32_t> rim;
  for (int y = 0; y < label.height; ++y) {
    const int32_t* row = &label.at(0, y);
    const int32_t* above = y > 0 ? row - w : nullptr;
    const int32_t* below = y + 1 < label.height ? row + w : nullptr;
    for (int x = 0; x < w; ++x) {
      if (row[x] <= 0) continue;
      if ((above && above[x] == 0) || (x > 0 && row[x - 1] == 0) ||
          (x + 1 < w && row[x + 1] == 0) || (below && below[x] == 0))
        rim.push_back(y * w + x);
    }
  }
  return rim;
}

/// Levels of the descending order per px of distance.
constexpr int level_steps = 8;

/// Returns a level above all finite distances of a field.
int32_t highest_level(const Image<int32_t>& squared) {
  return (squared.width + squared.height) * level_steps;
}

/// Returns the level of a squared distance, at most `cap`.
int32_t level_of(int32_t squared, int32_t cap) {
  const float distance = std::sqrt(static_cast<float>(squared));
  const auto level = static_cast<int32_t>(distance * float{level_steps});
  return level < cap ? level : cap;
}

/// Pixels are ordered by level, highest first, and in raster order within a level. The seniors of a
/// pixel are its neighbours that come before it. The way uphill leads to the senior with the
/// largest distance; a pixel without seniors is a peak, and one at distance 0 has no way.
enum Uphill : uint8_t { up = 0, left = 1, right = 2, down = 3, peak = 4, nowhere = 5 };

/// A row of squared distances and their levels, with a pixel of value 0 at either end.
struct FieldRow {
  std::vector<int32_t> squared;
  std::vector<int32_t> level;

  explicit FieldRow(int width)
      : squared(static_cast<size_t>(width) + 2), level(static_cast<size_t>(width) + 2) {}

  /// Reads row y of the field; a row beyond its end is 0.
  void read(const Image<int32_t>& field, int y, int32_t cap) {
    const int w = field.width;
    if (y >= field.height) {
      std::fill(squared.begin(), squared.end(), 0);
      std::fill(level.begin(), level.end(), 0);
      return;
    }
    const int32_t* in = &field.at(0, y);
    std::copy_n(in, w, squared.begin() + 1);
    int32_t* out = level.data() + 1;
    for (int x = 0; x < w; ++x) out[x] = level_of(in[x], cap);
  }
};

/// Finds the way uphill of each pixel of a row; of equal seniors, to the first. The loop
/// vectorises, as it has no branches and values of one width.
void uphill_of_row(const FieldRow& above, const FieldRow& row, const FieldRow& below,
                   std::vector<int32_t>& uphill) {
  const auto width = uphill.size();
  const int32_t* squared = row.squared.data() + 1;
  const int32_t* level = row.level.data() + 1;
  const int32_t* squared_above = above.squared.data() + 1;
  const int32_t* level_above = above.level.data() + 1;
  const int32_t* squared_below = below.squared.data() + 1;
  const int32_t* level_below = below.level.data() + 1;
  for (size_t x = 0; x < width; ++x) {
    const int32_t l = level[x];
    const int32_t at_up = squared_above[x] & -static_cast<int32_t>(level_above[x] >= l);
    const int32_t at_left = squared[x - 1] & -static_cast<int32_t>(level[x - 1] >= l);
    const int32_t at_right = squared[x + 1] & -static_cast<int32_t>(level[x + 1] > l);
    const int32_t at_down = squared_below[x] & -static_cast<int32_t>(level_below[x] > l);
    const int32_t upper = at_left > at_up ? at_left : at_up;
    const int32_t lower = at_down > at_right ? at_down : at_right;
    const int32_t upper_way = at_left > at_up ? left : up;
    const int32_t lower_way = at_down > at_right ? down : right;
    const int32_t way = lower > upper ? lower_way : upper_way;
    const int32_t found = (lower | upper) != 0 ? way : peak;
    uphill[x] = l > 0 ? found : nowhere;
  }
}

Image8 uphill_directions(const Image<int32_t>& squared) {
  const int32_t cap = highest_level(squared);
  Image8 uphill(squared.width, squared.height, 1);
  FieldRow above(squared.width);
  FieldRow row(squared.width);
  FieldRow below(squared.width);
  std::vector<int32_t> towards(static_cast<size_t>(squared.width));
  row.read(squared, 0, cap);
  for (int y = 0; y < squared.height; ++y) {
    below.read(squared, y + 1, cap);
    uphill_of_row(above, row, below, towards);
    std::copy(towards.begin(), towards.end(), &uphill.at(0, y));
    std::swap(above, row);
    std::swap(row, below);
  }
  return uphill;
}

/// Sorts things by level_of(thing), highest first; those of one level keep their order. A counting
/// sort: O(things + levels).
template <class Thing, class Level>
std::vector<Thing> highest_first(const std::vector<Thing>& things, const Level& level_of) {
  int32_t top = 0;
  for (const Thing& thing : things) top = std::max(top, level_of(thing));
  std::vector<size_t> begin(static_cast<size_t>(top) + 2, 0);
  for (const Thing& thing : things) ++begin[top - level_of(thing) + 1];
  for (size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
  std::vector<Thing> sorted(things.size());
  for (const Thing& thing : things) sorted[begin[top - level_of(thing)]++] = thing;
  return sorted;
}

/// Returns the pixels that are peaks, highest first.
std::vector<int32_t> find_peaks(const Image<int32_t>& squared, const Image8& uphill) {
  const int32_t cap = highest_level(squared);
  std::vector<int32_t> peaks;
  for (size_t i = 0; i < uphill.pixels.size(); ++i)
    if (uphill.pixels[i] == peak) peaks.push_back(static_cast<int32_t>(i));
  return highest_first(peaks, [&](int32_t pixel) { return level_of(squared.pixels[pixel], cap); });
}

/// Labels each pixel by the peak to which its way uphill leads: the index of the peak, from 1.
Image<int32_t> follow_uphill(const Image8& uphill, const std::vector<int32_t>& peaks) {
  const int32_t w = uphill.width;
  const std::array<int32_t, 4> step = {-w, -1, 1, w};
  Image<int32_t> label(w, uphill.height, 1);
  for (size_t k = 0; k < peaks.size(); ++k) label.pixels[peaks[k]] = static_cast<int32_t>(k) + 1;
  const auto count = static_cast<int32_t>(label.pixels.size());
  for (int32_t i = 0; i < count; ++i) {
    if (uphill.pixels[i] == nowhere) continue;
    int32_t end = i;
    while (label.pixels[end] == 0) end += step[uphill.pixels[end]];
    const int32_t found = label.pixels[end];
    for (int32_t j = i; j != end; j += step[uphill.pixels[j]]) label.pixels[j] = found;
  }
  return label;
}

/// A pixel of one label that has a senior of another.
struct Pass {
  int32_t level = 0;  ///< of the pixel
  int32_t a = 0;      ///< its label
  int32_t b = 0;      ///< label of the senior
};

/// Sets `borders` to other than 0 at the pixels of row y that share a side with another label.
void mark_borders(const Image<int32_t>& label, int y, std::vector<int32_t>& borders) {
  const int32_t* row = &label.at(0, y);
  const int32_t* above = y > 0 ? row - label.width : row;
  const int32_t* below = y + 1 < label.height ? row + label.width : row;
  const int w = label.width;
  const auto differ = [&](int x, int left, int right) {
    const int32_t own = row[x];
    return (own ^ row[left]) | (own ^ row[right]) | (own ^ above[x]) | (own ^ below[x]);
  };
  int32_t* out = borders.data();
  out[0] = differ(0, 0, std::min(1, w - 1));
  for (int x = 1; x + 1 < w; ++x) out[x] = differ(x, x - 1, x + 1);
  if (w > 1) out[w - 1] = differ(w - 1, w - 2, w - 1);
}

/// Lists all passes, highest first.
std::vector<Pass> find_passes(const Image<int32_t>& squared, const Image<int32_t>& label) {
  const int32_t cap = highest_level(squared);
  const int w = label.width;
  std::vector<Pass> passes;
  const auto look = [&](size_t i, size_t j, bool before) {
    if (label.pixels[j] == label.pixels[i] || label.pixels[j] == 0) return;
    const int32_t level = level_of(squared.pixels[i], cap);
    const int32_t beside = level_of(squared.pixels[j], cap);
    if (beside > level || (before && beside == level))
      passes.push_back({level, label.pixels[i], label.pixels[j]});
  };
  std::vector<int32_t> borders(static_cast<size_t>(w));
  for (int y = 0; y < label.height; ++y) {
    mark_borders(label, y, borders);
    for (int x = 0; x < w; ++x) {
      const size_t i = static_cast<size_t>(y) * w + x;
      if (borders[x] == 0 || label.pixels[i] == 0) continue;
      if (y > 0) look(i, i - w, true);
      if (x > 0) look(i, i - 1, true);
      if (x + 1 < w) look(i, i + 1, false);
      if (y + 1 < label.height) look(i, i + w, false);
    }
  }
  return highest_first(passes, [](const Pass& pass) { return pass.level; });
}

/// Unites basins at passes, highest first, where the lower peak does not rise enough above the
/// pass. `levels`: level of each peak, in order. A set of basins is represented by its highest
/// peak, the smallest member.
DisjointSets unite_basins(const std::vector<int32_t>& levels, const std::vector<Pass>& passes,
                          const BasinOptions& options) {
  DisjointSets sets(static_cast<int>(levels.size()) + 1);
  for (const Pass& pass : passes) {
    const int a = sets.find(pass.a);
    const int b = sets.find(pass.b);
    if (a == b) continue;
    const double top = levels[std::max(a, b) - 1];
    if (top - pass.level < options.min_rise * double{level_steps} ||
        pass.level > options.max_pass_ratio * top)
      sets.unite(a, b);
  }
  return sets;
}

}  // namespace

void flood_from_seeds(const Image8& height, Image<int32_t>& label) {
  assert(height.pixels.size() == label.pixels.size() && label.channels == 1);
  HeightQueues queues;
  const auto claim_around = [&](int32_t i) {
    for_sides(i, label.width, label.height, [&](int32_t j) {
      if (label.pixels[j] != 0) return;
      label.pixels[j] = label.pixels[i];
      queues.push(height.pixels[j], j);
    });
  };
  const std::vector<int32_t> rim = seeds_beside_open(label);
  for (const int32_t i : rim) claim_around(i);
  for (int32_t i = queues.pop(); i >= 0; i = queues.pop()) claim_around(i);
}

PeakBasins peak_basins(const Image<int32_t>& squared_distance, const BasinOptions& options) {
  assert(squared_distance.channels == 1);
  const Image8 uphill = uphill_directions(squared_distance);
  const std::vector<int32_t> peaks = find_peaks(squared_distance, uphill);
  std::vector<int32_t> levels;
  for (const int32_t pixel : peaks)
    levels.push_back(level_of(squared_distance.pixels[pixel], highest_level(squared_distance)));
  PeakBasins found{follow_uphill(uphill, peaks), {0}};
  DisjointSets sets = unite_basins(levels, find_passes(squared_distance, found.label), options);
  std::vector<int32_t> numbers(sets.size(), 0);
  for (int i = 1; i < sets.size(); ++i) {
    numbers[i] = numbers[sets.find(i)];
    if (sets.find(i) != i) continue;
    numbers[i] = static_cast<int32_t>(found.peaks.size());
    found.peaks.push_back(levels[i - 1] / double{level_steps});
  }
  for (int32_t& label : found.label.pixels) label = numbers[label];
  return found;
}

}  // namespace relievo

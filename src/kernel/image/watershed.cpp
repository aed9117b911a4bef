#include "kernel/image/watershed.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "kernel/base/disjoint_sets.h"

namespace relievo {
namespace {

/// Calls visit(index) for the up to four pixels that share a side with pixel i.
template <class Visit>
void for_sides(int32_t i, int width, int height, const Visit& visit) {
  const int y = static_cast<int>(static_cast<uint32_t>(i) / static_cast<uint32_t>(width));
  const int x = i - y * width;
  if (y > 0) visit(i - width);
  if (x > 0) visit(i - 1);
  if (x + 1 < width) visit(i + 1);
  if (y + 1 < height) visit(i + width);
}

/// First-in-first-out queues of pixels, one a height; the lowest is served first. A pixel that
/// comes in below the level being served joins that level.
class HeightQueues {
 public:
  void push(uint8_t height, int32_t pixel) {
    queues_[std::max<size_t>(height, level_)].push_back(pixel);
  }

  /// The next pixel, or -1 when there is none.
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

/// Pixels of seeds with one beside them that can be reached.
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

/// Steps of distance that the descending order tells apart, per px.
constexpr int level_steps = 8;

/// The distances of a field in steps.
class Levels {
 public:
  explicit Levels(const Image<int32_t>& squared)
      : cap_((squared.width + squared.height) * level_steps) {}

  int32_t operator()(int32_t squared) const {
    const float distance = std::sqrt(static_cast<float>(squared));
    const auto level = static_cast<int32_t>(distance * float{level_steps});
    return level < cap_ ? level : cap_;
  }

 private:
  int32_t cap_;
};

/// Pixels come highest level first, in raster order within a level; those beside a pixel that come
/// before it are its seniors. This is where the one with the largest distance is: a pixel without
/// any is a peak, one at distance 0 leads nowhere.
enum Uphill : uint8_t { up = 0, left = 1, right = 2, down = 3, peak = 4, nowhere = 5 };

/// A row of squared distances and their levels, with a pixel of 0 on either side.
struct FieldRow {
  std::vector<int32_t> squared;
  std::vector<int32_t> level;

  explicit FieldRow(int width)
      : squared(static_cast<size_t>(width) + 2), level(static_cast<size_t>(width) + 2) {}

  void read(const Image<int32_t>& field, int y, Levels level_of) {
    const int w = field.width;
    if (y >= field.height) {
      std::fill(squared.begin(), squared.end(), 0);
      std::fill(level.begin(), level.end(), 0);
      return;
    }
    const int32_t* in = &field.at(0, y);
    std::copy_n(in, w, squared.begin() + 1);
    int32_t* out = level.data() + 1;
    for (int x = 0; x < w; ++x) out[x] = level_of(in[x]);
  }
};

/// The way uphill of every pixel in a row; of seniors alike, the first. Without branches and in
/// values of one width, for the sake of vectors.
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
  const Levels level_of(squared);
  Image8 uphill(squared.width, squared.height, 1);
  FieldRow above(squared.width);
  FieldRow row(squared.width);
  FieldRow below(squared.width);
  std::vector<int32_t> towards(static_cast<size_t>(squared.width));
  row.read(squared, 0, level_of);
  for (int y = 0; y < squared.height; ++y) {
    below.read(squared, y + 1, level_of);
    uphill_of_row(above, row, below, towards);
    std::copy(towards.begin(), towards.end(), &uphill.at(0, y));
    std::swap(above, row);
    std::swap(row, below);
  }
  return uphill;
}

/// Orders things of a level, highest level first, those of one level as they came, by counting.
template <class Thing>
std::vector<Thing> highest_first(const std::vector<Thing>& things) {
  int32_t top = 0;
  for (const Thing& thing : things) top = std::max(top, thing.level);
  std::vector<size_t> begin(static_cast<size_t>(top) + 2, 0);
  for (const Thing& thing : things) ++begin[top - thing.level + 1];
  for (size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
  std::vector<Thing> sorted(things.size());
  for (const Thing& thing : things) sorted[begin[top - thing.level]++] = thing;
  return sorted;
}

struct Peak {
  int32_t level = 0;
  int32_t pixel = 0;
};

std::vector<Peak> find_peaks(const Image<int32_t>& squared, const Image8& uphill) {
  const Levels level_of(squared);
  std::vector<Peak> peaks;
  for (size_t i = 0; i < uphill.pixels.size(); ++i)
    if (uphill.pixels[i] == peak)
      peaks.push_back({level_of(squared.pixels[i]), static_cast<int32_t>(i)});
  return highest_first(peaks);
}

/// Labels every pixel as the peak to which it leads uphill, by the peak's place in the order
/// from 1.
Image<int32_t> follow_uphill(const Image8& uphill, const std::vector<Peak>& peaks) {
  const int32_t w = uphill.width;
  const std::array<int32_t, 4> step = {-w, -1, 1, w};
  Image<int32_t> label(w, uphill.height, 1);
  for (size_t k = 0; k < peaks.size(); ++k)
    label.pixels[peaks[k].pixel] = static_cast<int32_t>(k) + 1;
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

/// Where a pixel of one label has a senior of another.
struct Pass {
  int32_t level = 0;  ///< of the pixel
  int32_t a = 0;      ///< its label
  int32_t b = 0;      ///< label of the senior
};

/// Marks the pixels of a row with a label that differs from that of a pixel beside them.
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

/// All passes, highest first.
std::vector<Pass> find_passes(const Image<int32_t>& squared, const Image<int32_t>& label) {
  const Levels level_of(squared);
  const int w = label.width;
  std::vector<Pass> passes;
  const auto look = [&](size_t i, size_t j, bool before) {
    if (label.pixels[j] == label.pixels[i] || label.pixels[j] == 0) return;
    const int32_t level = level_of(squared.pixels[i]);
    const int32_t beside = level_of(squared.pixels[j]);
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
  return highest_first(passes);
}

/// Which basins are left; a set is the highest peak, its smallest member, and those it absorbed.
class BasinUnions {
 public:
  BasinUnions(const std::vector<Peak>& peaks, const BasinOptions& options)
      : peaks_(peaks), options_(options), sets_(static_cast<int>(peaks.size()) + 1) {}

  /// Two basins meet at a pass; the lower ends there if it does not rise enough above it.
  void meet(const Pass& pass) {
    const int a = sets_.find(pass.a);
    const int b = sets_.find(pass.b);
    if (a == b) return;
    const auto [higher, lower] = std::minmax({a, b});
    const double top = peaks_[lower - 1].level;
    if (top - pass.level < options_.min_rise * double{level_steps} ||
        pass.level > options_.max_pass_ratio * top)
      sets_.unite(higher, lower);
  }

  /// Numbers of the basins that are left, from 1, and their peaks.
  std::vector<int32_t> number(std::vector<double>& heights) {
    std::vector<int32_t> numbers(sets_.size(), 0);
    heights = {0};
    for (int i = 1; i < sets_.size(); ++i) {
      if (sets_.find(i) == i) {
        numbers[i] = static_cast<int32_t>(heights.size());
        heights.push_back(peaks_[i - 1].level / double{level_steps});
      } else {
        numbers[i] = numbers[sets_.find(i)];
      }
    }
    return numbers;
  }

 private:
  const std::vector<Peak>& peaks_;
  BasinOptions options_;
  DisjointSets sets_;
};

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
  const std::vector<Peak> peaks = find_peaks(squared_distance, uphill);
  PeakBasins found;
  found.label = follow_uphill(uphill, peaks);
  BasinUnions basins(peaks, options);
  for (const Pass& pass : find_passes(squared_distance, found.label)) basins.meet(pass);
  const std::vector<int32_t> numbers = basins.number(found.peaks);
  for (int32_t& label : found.label.pixels) label = numbers[label];
  return found;
}

}  // namespace relievo

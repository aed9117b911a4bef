#include "kernel/image/watershed.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "kernel/base/disjoint_sets.h"
#include "kernel/image/distance_transform.h"

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

/// Steps of distance that the descending order tells apart, per px.
constexpr float level_steps = 8;

/// Distances and labels side by side, in a frame of pixels at distance 0, so that a visit touches
/// little memory and needs no test for the border.
class FramedGrid {
 public:
  struct Pixel {
    int32_t squared = 0;
    int32_t label = 0;  ///< 0 where not yet visited
  };

  explicit FramedGrid(const Image<int32_t>& squared)
      : width_(squared.width),
        height_(squared.height),
        stride_(squared.width + 2),
        cap_(static_cast<float>(squared.width + squared.height)),
        pixels_(static_cast<size_t>(stride_) * (squared.height + 2)) {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) pixels_[index(x, y)].squared = squared.at(x, y);
  }

  Pixel& operator[](int32_t i) { return pixels_[i]; }
  int32_t level(int32_t i) const { return level_of(pixels_[i].squared); }
  /// The four pixels that share a side with a pixel of the inside.
  std::array<int32_t, 4> sides(int32_t i) const { return {i - stride_, i - 1, i + 1, i + stride_}; }

  /// Says that a pixel is visited soon, since the order jumps about in memory.
  void prefetch(int32_t i) const {
    for (const int32_t j : sides(i)) __builtin_prefetch(&pixels_[j]);
  }

  /// Pixels of positive distance, highest first, by counting sort; raster order within a level.
  std::vector<int32_t> descending() const {
    std::vector<int32_t> level(pixels_.size());
    int32_t top = 0;
    for (size_t i = 0; i < pixels_.size(); ++i) {
      level[i] = level_of(pixels_[i].squared);
      top = std::max(top, level[i]);
    }
    std::vector<int32_t> begin(static_cast<size_t>(top) + 2, 0);
    for (const int32_t l : level) ++begin[top - l + 1];
    for (size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
    std::vector<int32_t> order(begin[top]);
    for (size_t i = 0; i < level.size(); ++i)
      if (level[i] > 0) order[begin[top - level[i]]++] = static_cast<int32_t>(i);
    return order;
  }

  /// The labels with other numbers.
  Image<int32_t> labels(const std::vector<int32_t>& numbers) const {
    Image<int32_t> label(width_, height_, 1);
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) label.at(x, y) = numbers[pixels_[index(x, y)].label];
    return label;
  }

 private:
  size_t index(int x, int y) const { return static_cast<size_t>(y + 1) * stride_ + x + 1; }
  int32_t level_of(int32_t squared) const {
    return static_cast<int32_t>(std::min(cap_, std::sqrt(static_cast<float>(squared))) *
                                level_steps);
  }

  int width_;
  int height_;
  int32_t stride_;
  float cap_;
  std::vector<Pixel> pixels_;
};

constexpr size_t ahead = 12;  ///< visits between asking for a pixel and needing it

/// Peaks found so far; a set is an older peak, its smallest member, and those that it absorbed.
class Peaks {
 public:
  explicit Peaks(const BasinOptions& options) : options_(options) {}

  int32_t add(int32_t level) {
    peak_.push_back(level);
    return sets_.add();
  }

  /// Two basins meet at a pass; the younger ends there if it does not rise enough above it.
  void meet(int32_t a, int32_t b, int32_t pass) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (a == b) return;
    const auto [older, younger] = std::minmax({a, b});
    const double peak = peak_[younger];
    if (peak - pass < options_.min_rise * double{level_steps} ||
        pass > options_.max_pass_ratio * peak)
      sets_.unite(older, younger);
  }

  /// Numbers of the basins that are left, from 1, and their peaks.
  std::vector<int32_t> number(std::vector<double>& peaks) {
    std::vector<int32_t> numbers(sets_.size(), 0);
    peaks = {0};
    for (int i = 1; i < sets_.size(); ++i) {
      if (sets_.find(i) == i) {
        numbers[i] = static_cast<int32_t>(peaks.size());
        peaks.push_back(peak_[i] / double{level_steps});
      } else {
        numbers[i] = numbers[sets_.find(i)];
      }
    }
    return numbers;
  }

 private:
  BasinOptions options_;
  std::vector<int32_t> peak_ = {0};
  DisjointSets sets_{1};
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
  const auto is_open = [&](int32_t j) { return label.pixels[j] == 0; };
  std::vector<int32_t> rim;
  for (size_t i = 0; i < label.pixels.size(); ++i) {
    if (label.pixels[i] <= 0) continue;
    bool open = false;
    for_sides(static_cast<int32_t>(i), label.width, label.height,
              [&](int32_t j) { open = open || is_open(j); });
    if (open) rim.push_back(static_cast<int32_t>(i));
  }
  for (const int32_t i : rim) claim_around(i);
  for (int32_t i = queues.pop(); i >= 0; i = queues.pop()) claim_around(i);
}

PeakBasins peak_basins(const Image<int32_t>& squared_distance, const BasinOptions& options) {
  assert(squared_distance.channels == 1);
  FramedGrid grid(squared_distance);
  Peaks peaks(options);
  const std::vector<int32_t> order = grid.descending();
  for (size_t k = 0; k < order.size(); ++k) {
    const int32_t i = order[k];
    if (k + ahead < order.size()) grid.prefetch(order[k + ahead]);
    FramedGrid::Pixel uphill;
    bool alike = true;
    for (const int32_t j : grid.sides(i)) {
      const FramedGrid::Pixel side = grid[j];
      if (side.label == 0) continue;
      alike = alike && (uphill.label == 0 || side.label == uphill.label);
      if (uphill.label == 0 || side.squared > uphill.squared) uphill = side;
    }
    const int32_t label = uphill.label != 0 ? uphill.label : peaks.add(grid.level(i));
    grid[i].label = label;
    if (alike) continue;
    for (const int32_t j : grid.sides(i))
      if (const int32_t other = grid[j].label; other != 0 && other != label)
        peaks.meet(label, other, grid.level(i));
  }
  PeakBasins basins;
  basins.label = grid.labels(peaks.number(basins.peaks));
  return basins;
}

}  // namespace relievo

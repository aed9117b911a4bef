#include "understanding/scene/outline_rim.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "kernel/image/compose.h"
#include "kernel/image/distance_transform.h"

namespace relievo::understanding {
namespace {

constexpr double ink_share = 0.65;   ///< of the brightness of what it bounds, that ink has at most
constexpr double widest_ink = 0.03;  ///< of the diagonal
constexpr double slant = 0.85;       ///< of a line's width along rows and columns, in the median

int brightness(const uint8_t* rgba) {
  return on_paper(std::max({rgba[0], rgba[1], rgba[2]}), rgba[3]);
}

/// Counts how wide the ink is on the ways into the figure.
class InkMeter {
 public:
  InkMeter(const Image8& rgba, const Image16& labels,
           const std::vector<std::array<double, 3>>& colours)
      : rgba_(rgba),
        labels_(labels),
        runs_(static_cast<size_t>(widest_ink * std::hypot(labels.width, labels.height)) + 2, 0) {
    for (const auto& colour : colours)
      darkest_.push_back(ink_share * *std::max_element(colour.begin(), colour.end()));
  }

  /// Along `count` pixels from `first`, `step` apart.
  void scan(ptrdiff_t first, ptrdiff_t step, int count) {
    for (int k = 1; k < count; ++k) {
      const ptrdiff_t i = first + k * step;
      if (labels_.pixels[i] == 0 || labels_.pixels[i - step] != 0) continue;
      const uint16_t label = labels_.pixels[i];
      size_t run = 0;
      while (k + static_cast<int>(run) < count && run + 1 < runs_.size() &&
             is_ink(i + static_cast<ptrdiff_t>(run) * step, label))
        ++run;
      const ptrdiff_t end = i + static_cast<ptrdiff_t>(run) * step;
      const bool inside = k + static_cast<int>(run) < count && labels_.pixels[end] == label;
      if (inside && run + 1 < runs_.size()) ++runs_[run];
    }
  }

  double median() const {
    int64_t all = 0;
    for (const int64_t count : runs_) all += count;
    int64_t below = 0;
    for (size_t run = 0; run < runs_.size(); ++run)
      if ((below += runs_[run]) * 2 >= all && all > 0) return static_cast<double>(run);
    return 0;
  }

 private:
  bool is_ink(ptrdiff_t i, uint16_t label) const {
    return labels_.pixels[i] == label && brightness(&rgba_.pixels[4 * i]) < darkest_[label];
  }

  const Image8& rgba_;
  const Image16& labels_;
  std::vector<int64_t> runs_;  ///< how often ink is so wide, px
  std::vector<double> darkest_;
};

}  // namespace

double rim_width(const Image8& rgba, const Image16& labels,
                 const std::vector<std::array<double, 3>>& colours) {
  assert(rgba.width == labels.width && rgba.height == labels.height);
  InkMeter meter(rgba, labels, colours);
  const ptrdiff_t w = labels.width;
  const ptrdiff_t h = labels.height;
  for (ptrdiff_t y = 0; y < h; ++y) {
    meter.scan(y * w, 1, labels.width);
    meter.scan(y * w + w - 1, -1, labels.width);
  }
  for (ptrdiff_t x = 0; x < w; ++x) {
    meter.scan(x, w, labels.height);
    meter.scan((h - 1) * w + x, -w, labels.height);
  }
  return slant * meter.median() / 2;
}

Image16 without_rim(const Image16& labels, double rim) {
  if (rim < 1) return labels;
  Image8 background(labels.width, labels.height, 1);
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    background.pixels[i] = labels.pixels[i] == 0 ? 1 : 0;
  const Image<int32_t> to_background = squared_distance_to(background);
  Image8 core(labels.width, labels.height, 1);
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    core.pixels[i] = to_background.pixels[i] > rim * rim ? 1 : 0;
  const Image<int32_t> to_core = squared_distance_to(core);
  const double reach = rim + 1.5;
  Image16 inner = labels;
  std::vector<uint8_t> remains(size_t{1} << 16, 0);
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    if (core.pixels[i] == 0 && to_core.pixels[i] <= reach * reach)
      inner.pixels[i] = 0;
    else
      remains[labels.pixels[i]] = 1;
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    if (remains[labels.pixels[i]] == 0) inner.pixels[i] = labels.pixels[i];
  return inner;
}

Mask united(const Mask& a, const Mask& b) {
  Mask result = empty_mask(std::min(a.left, b.left), std::min(a.top, b.top),
                           std::max(a.right(), b.right()), std::max(a.bottom(), b.bottom()));
  for_each_pixel(a, [&](int x, int y) { result.add(x, y); });
  for_each_pixel(b, [&](int x, int y) { result.add(x, y); });
  return result;
}

}  // namespace relievo::understanding

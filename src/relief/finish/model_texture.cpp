#include "relief/finish/model_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "kernel/image/compose.h"
#include "kernel/image/morphology.h"
#include "relief/finish/fill_triangle.h"

namespace relievo::relief {
namespace {

/// Copies colours from known pixels to the others, to each from about the nearest in Chebyshev
/// distance: two passes over the pixels, each looking at the neighbours before it.
class Spread {
 public:
  Spread(int width, int height)
      : width_(width),
        stride_(static_cast<std::ptrdiff_t>(width) + 2),
        distance_(static_cast<size_t>(stride_) * (static_cast<size_t>(height) + 2), far) {}

  void mark_known(int x, int y) { distance_[at(x, y)] = 0; }

  void run(Image8& colours) {
    for (int y = 0; y < colours.height; ++y)
      for (int x = 0; x < width_; ++x) relax(x, y, -1, colours);
    for (int y = colours.height - 1; y >= 0; --y)
      for (int x = width_ - 1; x >= 0; --x) relax(x, y, 1, colours);
  }

 private:
  static constexpr uint16_t far = std::numeric_limits<uint16_t>::max();

  /// There is a margin of one pixel that is never near.
  std::ptrdiff_t at(int x, int y) const { return (std::ptrdiff_t{y} + 1) * stride_ + x + 1; }

  void relax(int x, int y, int step, Image8& colours) {
    const std::ptrdiff_t here = at(x, y);
    if (distance_[here] <= 1) return;
    const std::array<std::array<int, 2>, 4> offsets = {
        {{step, 0}, {-1, step}, {0, step}, {1, step}}};
    for (const auto& [dx, dy] : offsets) {
      const int next = distance_[here + dy * stride_ + dx] + 1;
      if (next >= distance_[here]) continue;
      distance_[here] = static_cast<uint16_t>(next);
      for (int c = 0; c < 3; ++c) colours.at(x, y, c) = colours.at(x + dx, y + dy, c);
    }
  }

  int width_;
  std::ptrdiff_t stride_;
  std::vector<uint16_t> distance_;
};

/// Chebyshev distance from a pixel that is not covered.
constexpr int silhouette_band = 2;

}  // namespace

Image8 model_texture(const Model& model, const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  if (rgba.empty()) return {};
  const Image8 near =
      max_filter(uncovered_pixels(model, {rgba.width, rgba.height}), silhouette_band);
  Image8 texture(rgba.width, rgba.height, 3, 255);
  Spread known(rgba.width, rgba.height);
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      const int alpha = rgba.at(x, y, 3);
      if (alpha < 255 && near.at(x, y) != 0) continue;
      known.mark_known(x, y);
      for (int c = 0; c < 3; ++c) texture.at(x, y, c) = on_paper(rgba.at(x, y, c), alpha);
    }
  known.run(texture);
  return texture;
}

}  // namespace relievo::relief

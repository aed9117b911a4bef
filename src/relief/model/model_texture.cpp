#include "relief/model/model_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace relievo {
namespace {

using Mask = Image<uint8_t>;

/// Pixels whose centre lies in the triangle with the given corners, in texture pixels.
void fill_triangle(Mask& mask, const std::array<Point2, 3>& corners) {
  const auto [a, b, c] = corners;
  const double area = cross(b - a, c - a);
  if (area == 0) return;
  const auto pixel = [](double v, int size) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(size)));
  };
  const int x0 = pixel(std::floor(std::min({a.x, b.x, c.x})), mask.width);
  const int x1 = pixel(std::ceil(std::max({a.x, b.x, c.x})), mask.width);
  const int y0 = pixel(std::floor(std::min({a.y, b.y, c.y})), mask.height);
  const int y1 = pixel(std::ceil(std::max({a.y, b.y, c.y})), mask.height);
  const double sign = area > 0 ? 1 : -1;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const Point2 p{x + 0.5, y + 0.5};
      if (sign * cross(b - a, p - a) >= 0 && sign * cross(c - b, p - b) >= 0 &&
          sign * cross(a - c, p - c) >= 0)
        mask.at(x, y) = 1;
    }
}

Mask cover(const Model& model, int width, int height) {
  Mask mask(width, height, 1);
  for (const std::array<int, 3>& triangle : model.triangles) {
    std::array<Point2, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      const Point2 uv = model.uvs[triangle[k]];
      corners[k] = {uv.x * width, uv.y * height};
    }
    fill_triangle(mask, corners);
  }
  return mask;
}

/// Chebyshev distance to the nearest pixel where `is_source`, capped at 65535, and that pixel's
/// colour copied along: two passes over the pixels, each looking at the neighbours before it.
class Spread {
 public:
  Spread(int width, int height) : distance_(width, height, 1, far) {}

  void mark_source(int x, int y) { distance_.at(x, y) = 0; }
  int distance(int x, int y) const { return distance_.at(x, y); }

  /// `colours` may be null when only distances are wanted.
  void run(Image8* colours) {
    for (int y = 0; y < distance_.height; ++y)
      for (int x = 0; x < distance_.width; ++x) relax(x, y, -1, colours);
    for (int y = distance_.height - 1; y >= 0; --y)
      for (int x = distance_.width - 1; x >= 0; --x) relax(x, y, 1, colours);
  }

 private:
  static constexpr uint16_t far = std::numeric_limits<uint16_t>::max();

  void relax(int x, int y, int step, Image8* colours) {
    const std::array<std::array<int, 2>, 4> offsets = {
        {{step, 0}, {-1, step}, {0, step}, {1, step}}};
    for (const auto& [dx, dy] : offsets) {
      const int from_x = x + dx;
      const int from_y = y + dy;
      if (from_x < 0 || from_x >= distance_.width || from_y < 0 || from_y >= distance_.height)
        continue;
      if (distance_.at(from_x, from_y) + 1 >= distance_.at(x, y)) continue;
      distance_.at(x, y) = static_cast<uint16_t>(distance_.at(from_x, from_y) + 1);
      if (colours != nullptr)
        for (int c = 0; c < 3; ++c) colours->at(x, y, c) = colours->at(from_x, from_y, c);
    }
  }

  Image<uint16_t> distance_;
};

constexpr int silhouette_band = 2;

/// Pixels of the cover that are further than the band from its border.
Spread distance_to_background(const Mask& covered) {
  Spread outside(covered.width, covered.height);
  for (int y = 0; y < covered.height; ++y)
    for (int x = 0; x < covered.width; ++x)
      if (covered.at(x, y) == 0) outside.mark_source(x, y);
  outside.run(nullptr);
  return outside;
}

uint8_t on_paper(int colour, int alpha) {
  return static_cast<uint8_t>((colour * alpha + 255 * (255 - alpha) + 127) / 255);
}

}  // namespace

Image8 model_texture(const Model& model, const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  if (rgba.empty()) return {};
  const Spread outside = distance_to_background(cover(model, rgba.width, rgba.height));
  Image8 texture(rgba.width, rgba.height, 3, 255);
  Spread known(rgba.width, rgba.height);
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      const int alpha = rgba.at(x, y, 3);
      if (alpha < 255 && outside.distance(x, y) <= silhouette_band) continue;
      known.mark_source(x, y);
      for (int c = 0; c < 3; ++c) texture.at(x, y, c) = on_paper(rgba.at(x, y, c), alpha);
    }
  known.run(&texture);
  return texture;
}

}  // namespace relievo

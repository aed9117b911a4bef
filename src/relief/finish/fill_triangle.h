#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "kernel/image/image_size.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/point.h"

namespace relievo::relief {

/// Returns the corners of a model's triangle in pixels of an image of the drawing.
inline std::array<Point2, 3> corners_on_image(const Model& model, size_t triangle, ImageSize size) {
  std::array<Point2, 3> corners;
  for (size_t k = 0; k < 3; ++k) {
    const Point2 uv = model.uvs[model.triangles[triangle][k]];
    corners[k] = {uv.x * size.width, uv.y * size.height};
  }
  return corners;
}

/// Calls visit(x, y) for every pixel of an image whose centre lies in a triangle, given in pixels.
template <class Visit>
void for_each_pixel_inside(const std::array<Point2, 3>& corners, ImageSize size, Visit visit) {
  const auto [a, b, c] = corners;
  const double area = cross(b - a, c - a);
  if (area == 0) return;
  const auto pixel = [](double v, int most) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(most)));
  };
  const int x0 = pixel(std::floor(std::min({a.x, b.x, c.x})), size.width);
  const int x1 = pixel(std::ceil(std::max({a.x, b.x, c.x})), size.width);
  const int y0 = pixel(std::floor(std::min({a.y, b.y, c.y})), size.height);
  const int y1 = pixel(std::ceil(std::max({a.y, b.y, c.y})), size.height);
  const double sign = area > 0 ? 1 : -1;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const Point2 p{x + 0.5, y + 0.5};
      if (sign * cross(b - a, p - a) >= 0 && sign * cross(c - b, p - b) >= 0 &&
          sign * cross(a - c, p - c) >= 0)
        visit(x, y);
    }
}

/// Returns an image of the drawing, 1 on the pixels that no triangle of the model covers, else 0.
inline Image8 uncovered_pixels(const Model& model, ImageSize size) {
  Image8 mask(size.width, size.height, 1, 1);
  for (size_t t = 0; t < model.triangles.size(); ++t)
    for_each_pixel_inside(corners_on_image(model, t, size), size,
                          [&mask](int x, int y) { mask.at(x, y) = 0; });
  return mask;
}

/// Returns the part seen at every pixel of an image of the drawing, counted from 1, or 0.
inline Image16 front_parts(const Model& model, ImageSize size) {
  Image16 front(size.width, size.height, 1);
  for (size_t p = 0; p < model.parts.size(); ++p) {
    const ModelPart& part = model.parts[p];
    for (int t = part.first_triangle; t < part.seen_end(); ++t)
      for_each_pixel_inside(corners_on_image(model, t, size), size, [&front, p](int x, int y) {
        front.at(x, y) = static_cast<uint16_t>(p + 1);
      });
  }
  return front;
}

}  // namespace relievo::relief

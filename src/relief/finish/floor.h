#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/image_size.h"
#include "relief/finish/fill_triangle.h"
#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// The greatest height of the parts added so far, on a small raster of the canvas.
class Floor {
 public:
  explicit Floor(const Model& model)
      : size_(fitted_size(model.width, model.height, longest_floor)),
        height_(size_.width, size_.height, 1, std::numeric_limits<float>::lowest()) {}

  /// Adds a part.
  void add(const Model& model, const ModelPart& part) {
    const std::vector<Point3>& positions = model.positions;
    for (int t = part.first_triangle; t < part.end(); ++t) {
      std::array<Point2, 3> corners;
      for (size_t k = 0; k < 3; ++k) {
        const Point3 p = positions[model.triangles[t][k]];
        corners[k] = {p.x / model.width * size_.width, (1 - p.y / model.height) * size_.height};
      }
      const auto [a, b, c] = corners;
      const double area = cross(b - a, c - a);
      const auto z = [&](size_t k) { return positions[model.triangles[t][k]].z; };
      for_each_pixel_inside({a, b, c}, size_, [&, a = a, b = b, c = c](int x, int y) {
        const Point2 p{x + 0.5, y + 0.5};
        const double v = cross(p - a, c - a) / area;
        const double w = cross(b - a, p - a) / area;
        float& most = height_.at(x, y);
        most = std::max(most, static_cast<float>((1 - v - w) * z(0) + v * z(1) + w * z(2)));
      });
    }
  }

  /// Returns the greatest height around a place on the drawing, lowest() where no part is.
  double height_at(Point2 uv) const {
    const int x = static_cast<int>(std::floor(uv.x * size_.width - 0.5));
    const int y = static_cast<int>(std::floor(uv.y * size_.height - 0.5));
    float most = std::numeric_limits<float>::lowest();
    for (const int u : {x, x + 1})
      for (const int v : {y, y + 1})
        most = std::max(most, height_.at(std::clamp(u, 0, size_.width - 1),
                                         std::clamp(v, 0, size_.height - 1)));
    return most;
  }

 private:
  static constexpr int longest_floor = 1024;  ///< px
  ImageSize size_;
  ImageF height_;
};

}  // namespace relievo::relief

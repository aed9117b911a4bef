#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace relievo {

/// The size of a picture in px.
struct ImageSize {
  int width = 0;
  int height = 0;
};

/// Returns the size of a picture with the aspect ratio of width x height whose longer side has
/// `longest` px; at least one px a side.
inline ImageSize fitted_size(double width, double height, double longest) {
  const auto pixels = [&](double side) {
    return std::max(1, static_cast<int>(std::lround(longest * side / std::max(width, height))));
  };
  return {pixels(width), pixels(height)};
}

/// Calls visit(x, y) once for each pixel of the picture's edge.
template <class Visit>
void along_edge(int width, int height, Visit visit) {
  for (int x = 0; x < width; ++x) {
    visit(x, 0);
    if (height > 1) visit(x, height - 1);
  }
  for (int y = 1; y + 1 < height; ++y) {
    visit(0, y);
    if (width > 1) visit(width - 1, y);
  }
}

/// Computes the share of the picture's edge, 2 (width + height) px, at which is(x, y) is true.
template <class Is>
double share_of_edge(int width, int height, Is is) {
  int64_t count = 0;
  along_edge(width, height, [&](int x, int y) { count += is(x, y) ? 1 : 0; });
  return static_cast<double>(count) / (2.0 * (width + height));
}

}  // namespace relievo

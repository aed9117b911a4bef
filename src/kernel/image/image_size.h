#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace relievo {

struct ImageSize {
  int width = 0;
  int height = 0;
};

/// The pixels, at least one a side, of a picture of the shape width x height whose longest side
/// has `longest` of them.
inline ImageSize fitted_size(double width, double height, double longest) {
  const auto pixels = [&](double side) {
    return std::max(1, static_cast<int>(std::lround(longest * side / std::max(width, height))));
  };
  return {pixels(width), pixels(height)};
}

/// Calls visit(x, y) once for every pixel of the picture's edge.
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

/// The share of the pixels of the picture's edge of which is(x, y) is true.
template <class Is>
double share_of_edge(int width, int height, Is is) {
  int64_t count = 0;
  along_edge(width, height, [&](int x, int y) { count += is(x, y) ? 1 : 0; });
  return static_cast<double>(count) / (2.0 * (width + height));
}

}  // namespace relievo

#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace relievo {

/// An sRGB colour with straight alpha, all in [0, 1].
struct Color {
  double r = 0;
  double g = 0;
  double b = 0;
  double a = 1;
};

/// Computes the Euclidean distance of two colours without alpha, in [0, sqrt 3].
inline double color_distance(const Color& p, const Color& q) {
  return std::hypot(p.r - q.r, p.g - q.g, p.b - q.b);
}

/// The colours of one part, without alpha, the main one first.
using Palette = std::vector<std::array<double, 3>>;

/// Computes the luma, the Rec. 709 weights on the sRGB values, in [0, 1].
inline double luminance(const Color& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

}  // namespace relievo

#pragma once

#include <cmath>

namespace relievo {

/// sRGB with straight alpha, all in [0, 1].
struct Color {
  double r = 0;
  double g = 0;
  double b = 0;
  double a = 1;
};

/// Euclidean distance of the colours without alpha, in [0, sqrt 3].
inline double color_distance(const Color& p, const Color& q) {
  return std::hypot(p.r - q.r, p.g - q.g, p.b - q.b);
}

}  // namespace relievo

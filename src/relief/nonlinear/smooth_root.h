#pragma once

#include <algorithm>
#include <cmath>

#include "relief/inflation/inflation.h"

namespace relievo {

/// f = sgn(u) sqrt|u| and its inverse, in scene units. The slope of the root has no bound at 0;
/// with a width w > 0 it is at most 1/w: f = u / (u^2 + w^4)^(1/4), the same to (w / f)^4 / 4.
class SmoothRoot {
 public:
  explicit SmoothRoot(double width = 0) : w4_(width * width * width * width) {}

  double f(double u) const {
    if (w4_ == 0) return signed_root(u);
    return u / std::sqrt(std::sqrt(u * u + w4_));
  }

  /// df / du; of the sharp root as at |f| = smallest_f where |f| is less.
  double slope(double u) const {
    if (w4_ == 0) return 1 / (2 * std::max(std::sqrt(std::abs(u)), smallest_f));
    const double s = u * u + w4_;
    return (u * u / 2 + w4_) / (s * std::sqrt(std::sqrt(s)));
  }

  /// The u whose root is f.
  double u(double f) const {
    const double f4 = f * f * f * f;
    return std::copysign(std::sqrt((f4 + std::sqrt(f4 * (f4 + 4 * w4_))) / 2), f);
  }

 private:
  static constexpr double smallest_f = 1e-3;
  double w4_;
};

}  // namespace relievo

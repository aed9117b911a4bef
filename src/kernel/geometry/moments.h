#pragma once

#include <algorithm>
#include <cmath>

#include "relievo/point.h"

namespace relievo {

/// The principal axes of a set of points; all zero where there are none.
struct MainAxes {
  Point2 centre;
  Point2 along;        ///< unit vector of the longer axis, of either sign
  double longer = 0;   ///< variance along the longer axis
  double shorter = 0;  ///< variance across it
};

/// Sums the first and second moments of points.
class Moments {
 public:
  void add(Point2 p) {
    ++count_;
    sum_ = sum_ + p;
    xx_ += p.x * p.x;
    xy_ += p.x * p.y;
    yy_ += p.y * p.y;
  }

  /// Computes the principal axes of the points added.
  MainAxes axes() const {
    if (count_ == 0) return {};
    const Point2 centre = 1 / count_ * sum_;
    const double a = xx_ / count_ - centre.x * centre.x;
    const double b = xy_ / count_ - centre.x * centre.y;
    const double c = yy_ / count_ - centre.y * centre.y;
    const double spread = std::sqrt((a - c) * (a - c) / 4 + b * b);
    const double angle = std::atan2(2 * b, a - c) / 2;
    return {centre,
            {std::cos(angle), std::sin(angle)},
            (a + c) / 2 + spread,
            std::max((a + c) / 2 - spread, 0.0)};
  }

 private:
  double count_ = 0;
  Point2 sum_;
  double xx_ = 0;
  double xy_ = 0;
  double yy_ = 0;
};

}  // namespace relievo

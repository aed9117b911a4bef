#pragma once

#include <cmath>
#include <vector>

#include "relievo/point.h"

namespace relievo::relief {

/// Inflated heights f = sgn(u) sqrt|u| before ordering [P eq 7-9]. u is piecewise linear on the
/// faces. Interpolate u and take the root afterwards, because f has infinite slope at outlines.
struct Inflation {
  std::vector<double> u;       ///< #N, px^2, negative on parts with d < 0
  std::vector<Point2> grad_u;  ///< #N, gradient of u at the node, px, canvas axes (y down)
};

/// Returns sgn(u) sqrt|u|.
inline double signed_root(double u) { return std::copysign(std::sqrt(std::abs(u)), u); }

}  // namespace relievo::relief

#pragma once

#include <vector>

#include "relievo/point.h"

namespace relievo {

/// A point with a direction of travel (unit length).
struct DirectedPoint {
  Point2 at;
  Point2 direction;
};

/// The smooth arc from `from` to `to` with the given directions at its ends: a cubic with Hobby's
/// end tangents, with which a quarter of a circle comes out round to 0.05 % and half of one to 2 %
/// (J. D. Hobby, Smooth, easy to compute interpolating splines, 1986). Sampled about every `step`
/// px; neither end is included.
std::vector<Point2> smooth_arc(const DirectedPoint& from, const DirectedPoint& to, double step);

/// Angle by which the arc turns from its chord, at both ends together, in radians; positive to
/// the right on the screen (clockwise).
double turning(const DirectedPoint& from, const DirectedPoint& to);

}  // namespace relievo

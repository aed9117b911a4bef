#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"

namespace relievo {

/// Arc length along a closed ring.
struct RingMeasure {
  std::vector<double> start;  ///< per point, its arc length from the first point
  double length = 0;          ///< of the whole ring
};

/// The foot of a perpendicular on a ring.
struct RingFoot {
  double s = 0;         ///< arc length of the foot
  double distance = 0;  ///< from the point to the foot
};

/// O(n).
RingMeasure measure(const Ring& ring);

/// The point at arc length s, taken modulo the ring's length. O(log n).
Point2 point_at(const Ring& ring, const RingMeasure& m, double s);

/// The nearest point of the ring. O(n).
RingFoot nearest_on_ring(const Ring& ring, const RingMeasure& m, Point2 p);

/// Distance from p to the open polyline. O(n).
double distance_to_polyline(const std::vector<Point2>& line, Point2 p);

/// Distance from p to the segment ab.
double distance_to_segment(Point2 p, Point2 a, Point2 b);

}  // namespace relievo

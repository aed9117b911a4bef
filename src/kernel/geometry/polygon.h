#pragma once

#include <limits>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// An axis-aligned box; empty where max < min, as it is at first.
struct Box2 {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point2 min{infinity, infinity};
  Point2 max{-infinity, -infinity};
  bool empty() const { return max.x < min.x; }
  /// Extends the box to contain the point.
  void add(Point2 p);
  /// Extends the box to contain another one.
  void add(const Box2& box);
  /// Returns the length of the diagonal; 0 where the box is empty.
  double diagonal() const { return empty() ? 0 : distance(min, max); }
};

/// Computes the signed area, positive where the ring runs clockwise on the screen (y down). O(n).
double signed_area(const Ring& ring);

/// Computes the area without the holes. Precondition: rings run as after orient_by_nesting. O(n).
double area(const Outline& outline);

/// Computes the length of the closed ring. O(n).
double perimeter(const Ring& ring);

/// Computes the smallest box around all points. O(n).
Box2 bounding_box(const Ring& ring);
Box2 bounding_box(const Outline& outline);

/// Computes the convex hull as a ring that runs clockwise on the screen, without points along its
/// sides (Andrew 1979). Returns fewer than three points as they are. O(n log n).
Ring convex_hull(std::vector<Point2> points);

/// Computes the winding number of `ring` around `p`. On the ring itself it is that of either side.
/// O(n).
int winding_number(const Ring& ring, Point2 p);

/// Returns whether `p` is inside by the non-zero rule. O(n).
bool contains(const Outline& outline, Point2 p);

/// Reverses rings so that those at even nesting depth have positive signed area and those at odd
/// depth (holes) negative. The depth of a ring is the number of other rings around its first point.
/// Rings keep their first point, and those without area their direction, so that calling it again
/// changes nothing. O(rings * points).
void orient_by_nesting(Outline& outline);

/// Arc lengths along a closed ring.
struct RingMeasure {
  std::vector<double> start;  ///< #n, arc length of each point from the first one
  double length = 0;          ///< length of the whole ring
};

/// The point of a ring nearest to another point.
struct RingFoot {
  double s = 0;         ///< arc length of the nearest point
  double distance = 0;  ///< between both
};

/// Computes the arc lengths of the ring's points. O(n).
RingMeasure measure(const Ring& ring);

/// Returns the point at arc length s, taken modulo the ring's length. O(log n).
Point2 point_at(const Ring& ring, const RingMeasure& m, double s);

/// Finds the point of the ring nearest to p. O(n).
RingFoot nearest_on_ring(const Ring& ring, const RingMeasure& m, Point2 p);

/// Computes the distance from p to the open polyline; infinite where it has no point. O(n).
double distance_to_polyline(const std::vector<Point2>& line, Point2 p);

/// Computes the distance from p to the segment ab.
double distance_to_segment(Point2 p, Point2 a, Point2 b);

}  // namespace relievo

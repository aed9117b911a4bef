#pragma once

#include <limits>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// An axis-aligned box; empty while max < min.
struct Box2 {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point2 min{infinity, infinity};
  Point2 max{-infinity, -infinity};
  bool empty() const { return max.x < min.x; }
  void add(Point2 p);
  void add(const Box2& box);
  double diagonal() const { return empty() ? 0 : distance(min, max); }
};

/// Signed area; positive where the ring runs clockwise as seen on the screen (y down). O(n).
double signed_area(const Ring& ring);

/// Area, without holes, of an outline whose rings run as after orient_by_nesting. O(n).
double area(const Outline& outline);

/// Length of the closed ring. O(n).
double perimeter(const Ring& ring);

Box2 bounding_box(const Ring& ring);
Box2 bounding_box(const Outline& outline);

/// The least convex ring around the points, clockwise as seen on the screen, without points along
/// its sides (Andrew 1979). Fewer than three points are kept. O(n log n).
Ring convex_hull(std::vector<Point2> points);

/// Winding number of `ring` around `p`; on the ring itself it is that of one of its sides. O(n).
int winding_number(const Ring& ring, Point2 p);

/// Whether `p` is inside by the non-zero rule. O(n).
bool contains(const Outline& outline, Point2 p);

/// Runs every ring so that rings at even nesting depth have positive signed area and those at
/// odd depth (holes) negative; the depth of a ring is the number of other rings around its
/// first point. Rings keep their first point, and those without area their direction, so that
/// doing it again changes nothing. O(rings * points).
void orient_by_nesting(Outline& outline);

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

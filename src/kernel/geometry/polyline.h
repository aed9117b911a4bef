#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/point.h"

namespace relievo {

/// A stretch of a polyline by arc length from its first point.
struct LineSpan {
  double from = 0;
  double to = 0;
};

/// Returns the stretches of the polyline inside the outline by the non-zero rule, in order.
/// O(points of the line * points of the outline).
std::vector<LineSpan> spans_inside(const std::vector<Point2>& line, const Outline& outline);

/// A crossing of a line with an outline.
struct LineCrossing {
  double s = 0;  ///< position along the line
  int turn = 0;  ///< change of the outline's winding number there, 1 or -1
};

/// Calls visit(from, to) for each stretch between consecutive crossings where the winding number is
/// not 0. `crossings` are sorted along the line, which begins outside the outline. O(crossings).
template <class Visit>
void for_each_span_inside(const std::vector<LineCrossing>& crossings, Visit visit) {
  int winding = 0;
  for (size_t i = 0; i + 1 < crossings.size(); ++i) {
    winding += crossings[i].turn;
    if (winding != 0) visit(crossings[i].s, crossings[i + 1].s);
  }
}

/// Computes the sum of the segments' lengths. O(n).
double line_length(const std::vector<Point2>& line);

/// Returns the point of the polyline at arc length s. Beyond its ends the polyline goes on
/// straight. Precondition: consecutive points differ. O(n).
Point2 point_on_line(const std::vector<Point2>& line, double s);

/// Simplifies a polyline to some of its points, its ends among them: the others are at most
/// `tolerance` from the result (Douglas, Peucker 1973). O(n log n) for lines without much detail,
/// O(n^2) at worst.
std::vector<Point2> simplify_line(const std::vector<Point2>& line, double tolerance);

/// Computes the angle from one direction to another, in (-pi, pi], positive clockwise on the
/// screen.
double turn_between(Point2 from, Point2 to);

/// A point with a direction of travel (unit length).
struct DirectedPoint {
  Point2 at;
  Point2 direction;
};

/// Samples the smooth arc between two points with the given directions there about every `step` px,
/// both ends excluded. The arc is a cubic with Hobby's end tangents, which reproduce a quarter of a
/// circle to 0.05 % and half a circle to 2 % (J. D. Hobby, Smooth, easy to compute interpolating
/// splines, 1986).
std::vector<Point2> smooth_arc(const DirectedPoint& from, const DirectedPoint& to, double step);

/// Computes the total angle by which smooth_arc turns, the sum of the angles to its chord at both
/// ends, in radians, positive clockwise on the screen.
double turning(const DirectedPoint& from, const DirectedPoint& to);

/// Computes the bending energy, up to a factor, of the cubic that makes the angles `first` and
/// `second` (radians) with its chord at its ends. Least where both turn the same way.
inline double bend_energy(double first, double second) {
  return first * first + second * second - first * second;
}

}  // namespace relievo

#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/point.h"

namespace relievo {

/// A stretch of a polyline, as arc lengths from its first point.
struct LineSpan {
  double from = 0;
  double to = 0;
};

/// The stretches of the polyline inside the outline, by the non-zero rule, in order.
/// O(points of the line * points of the outline).
std::vector<LineSpan> spans_inside(const std::vector<Point2>& line, const Outline& outline);

/// Sum of the segments' lengths. O(n).
double line_length(const std::vector<Point2>& line);

/// The point of the polyline at arc length s; beyond its ends it goes on straight. Precondition:
/// consecutive points differ. O(n).
Point2 point_on_line(const std::vector<Point2>& line, double s);

/// The polyline with fewer of its points: its ends, and those from which the others depart by at
/// most `tolerance` (Douglas, Peucker 1973). O(n log n) for lines without much detail, O(n^2) at
/// worst.
std::vector<Point2> simplify_line(const std::vector<Point2>& line, double tolerance);

/// The angle from one direction to another, in (-pi, pi]; positive clockwise on the screen.
double turn_between(Point2 from, Point2 to);

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

/// Energy of the cubic that leaves its chord by one angle and comes back to it by another, in
/// rad^2 and up to a factor; 0 where both are, least where both turn the same way.
inline double bend_energy(double first, double second) {
  return first * first + second * second - first * second;
}

}  // namespace relievo

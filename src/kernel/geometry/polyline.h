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

/// A grid of square cells in the plane.
struct CellGrid {
  Point2 origin;    ///< corner of the first cell
  double cell = 1;  ///< side of a cell
  int columns = 0;
  int rows = 0;
};

/// Cells [begin, end) of a row of a grid.
struct CellRun {
  int row = 0;
  int begin = 0;
  int end = 0;
};

/// Returns the first of `size` cells of a row whose centre is at or after v, in cells from the
/// row's beginning; `size` where there is none.
int first_centre(double v, int size);

/// Returns the cells whose centres are inside the outline by the non-zero rule, row by row.
/// O(points + crossed rows).
std::vector<CellRun> cells_inside(const Outline& outline, const CellGrid& grid);

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

#include "kernel/geometry/smooth_arc.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/exact_functions.h"

namespace relievo {
namespace {

/// Signed angle from a to b.
double angle(Point2 a, Point2 b) { return exact::angle_of(cross(a, b), dot(a, b)); }

/// Length of a Bezier handle relative to the chord, given the angles of both ends to it.
double handle(double own, double other) {
  const double sqrt5 = std::sqrt(5.0);
  const exact::Direction a = exact::direction_of(own);
  const exact::Direction b = exact::direction_of(other);
  const double bend = (a.sine - b.sine / 16) * (b.sine - a.sine / 16) * (a.cosine - b.cosine);
  const double spread = 3 * (1 + 0.5 * (sqrt5 - 1) * a.cosine + 0.5 * (3 - sqrt5) * b.cosine);
  // The denominator nears 0 where both ends point backwards; beyond 3 chords it is a loop.
  return std::clamp((2 + std::sqrt(2.0) * bend) / std::max(spread, 1e-3), 0.05, 3.0);
}

}  // namespace

double turning(const DirectedPoint& from, const DirectedPoint& to) {
  const Point2 chord = to.at - from.at;
  return angle(from.direction, chord) + angle(chord, to.direction);
}

std::vector<Point2> smooth_arc(const DirectedPoint& from, const DirectedPoint& to, double step) {
  const Point2 chord = to.at - from.at;
  const double length = norm(chord);
  if (length <= step) return {};
  const double start = angle(from.direction, chord);
  const double end = angle(chord, to.direction);
  const double h0 = length * handle(start, end);
  const double h1 = length * handle(end, start);
  const Point2 b = from.at + h0 * from.direction;
  const Point2 c = to.at - h1 * to.direction;
  const double control = h0 + distance(b, c) + h1;
  const int count = static_cast<int>(std::ceil(control / step));
  std::vector<Point2> arc;
  for (int i = 1; i < count; ++i) {
    const double t = static_cast<double>(i) / count;
    const double s = 1 - t;
    arc.push_back(s * s * s * from.at + 3 * s * s * t * b +
                  (3 * s * t * t * c + t * t * t * to.at));
  }
  return arc;
}

}  // namespace relievo

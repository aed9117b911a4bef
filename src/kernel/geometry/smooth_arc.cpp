#include "kernel/geometry/smooth_arc.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

/// Signed angle from a to b.
double angle(Point2 a, Point2 b) { return std::atan2(cross(a, b), dot(a, b)); }

/// Length of a Bezier handle relative to the chord, given the angles of both ends to it.
double handle(double own, double other) {
  const double sqrt5 = std::sqrt(5.0);
  const double bend = (std::sin(own) - std::sin(other) / 16) *
                      (std::sin(other) - std::sin(own) / 16) * (std::cos(own) - std::cos(other));
  const double spread =
      3 * (1 + 0.5 * (sqrt5 - 1) * std::cos(own) + 0.5 * (3 - sqrt5) * std::cos(other));
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

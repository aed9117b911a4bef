#include "relief/drawing/find_bridges.h"

#include <algorithm>
#include <utility>

#include "kernel/image/label_arcs.h"
#include "kernel/image/morphology.h"

namespace relievo {
namespace {

constexpr double tolerance = 1;  ///< px that a bridge may depart from the sides of pixels
constexpr int line_margin = 1;   ///< px by which a boundary may leave the line it runs along

/// Whether the side of a pixel from a to b lies open on both sides, within the image.
bool is_open(const Image8& barrier, PixelCorner a, PixelCorner b) {
  const bool horizontal = a.y == b.y;
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  const int other_x = horizontal ? x : x - 1;
  const int other_y = horizontal ? y - 1 : y;
  if (other_x < 0 || other_y < 0 || x >= barrier.width || y >= barrier.height) return false;
  return barrier.at(x, y) == 0 && barrier.at(other_x, other_y) == 0;
}

double distance_to_chord(Point2 p, Point2 a, Point2 b) {
  const double length = distance(a, b);
  return length > 0 ? std::abs(cross(b - a, p - a)) / length : distance(a, p);
}

/// Keeps the points that others depart from (Douglas, Peucker 1973).
void simplify(const std::vector<Point2>& points, size_t first, size_t last,
              std::vector<Point2>& kept) {
  size_t farthest = first;
  double worst = tolerance;
  for (size_t k = first + 1; k < last; ++k)
    if (const double d = distance_to_chord(points[k], points[first], points[last]); d > worst) {
      worst = d;
      farthest = k;
    }
  if (farthest != first) {
    simplify(points, first, farthest, kept);
    simplify(points, farthest, last, kept);
    return;
  }
  kept.push_back(points[last]);
}

Bridge bridge_of(const LabelArc& arc, size_t first, size_t last) {
  std::vector<Point2> points;
  for (size_t k = first; k <= last; ++k)
    points.push_back(Point2{arc.corners[k].x * 1.0, arc.corners[k].y * 1.0});
  Bridge bridge{{points.front()}, std::min(arc.left, arc.right), std::max(arc.left, arc.right)};
  simplify(points, 0, points.size() - 1, bridge.points);
  return bridge;
}

}  // namespace

std::vector<Bridge> find_bridges(const Image16& labels, const Image8& barrier, double line_width) {
  const auto shortest = static_cast<size_t>(std::max(3.0, line_width));
  const Image8 near_line = max_filter(barrier, line_margin);
  std::vector<Bridge> bridges;
  for (const LabelArc& arc : trace_label_arcs(labels)) {
    const size_t sides = arc.corners.size() - 1;
    for (size_t first = 0, last = 0; first < sides; first = last + 1) {
      last = first;
      while (last < sides && is_open(near_line, arc.corners[last], arc.corners[last + 1])) ++last;
      if (last - first >= shortest) bridges.push_back(bridge_of(arc, first, last));
    }
  }
  return bridges;
}

}  // namespace relievo

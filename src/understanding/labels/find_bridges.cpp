#include "understanding/labels/find_bridges.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/cyclic_runs.h"
#include "kernel/geometry/polyline.h"
#include "kernel/image/outlines.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr double tolerance = 1;     ///< px, largest distance of a bridge from the pixel sides
constexpr int boundary_margin = 1;  ///< px, largest distance of a boundary from its line

/// Returns whether no pixel within the margin of a pixel of the image is on a line or edge.
bool is_far_from_lines(const Image8& barrier, int x, int y) {
  for (int v = std::max(0, y - boundary_margin);
       v <= std::min(barrier.height - 1, y + boundary_margin); ++v)
    for (int u = std::max(0, x - boundary_margin);
         u <= std::min(barrier.width - 1, x + boundary_margin); ++u)
      if (barrier.at(u, v) == LineMap::line || barrier.at(u, v) == LineMap::edge) return false;
  return true;
}

/// Returns whether both pixels at a pixel side, given by its middle, lie in the image and far from
/// lines.
bool is_open(const Image8& barrier, Point2 side) {
  const int x = static_cast<int>(side.x);
  const int y = static_cast<int>(side.y);
  const bool horizontal = side.y == y;
  const int other_x = horizontal ? x : x - 1;
  const int other_y = horizontal ? y - 1 : y;
  if (other_x < 0 || other_y < 0 || x >= barrier.width || y >= barrier.height) return false;
  return is_far_from_lines(barrier, x, y) && is_far_from_lines(barrier, other_x, other_y);
}

std::vector<uint8_t> open_sides(const LabelRing& ring, const Image8& barrier) {
  std::vector<uint8_t> open;
  for (const Point2 side : ring.sides) open.push_back(is_open(barrier, side) ? 1 : 0);
  return open;
}

Bridge bridge_of(const LabelRing& ring, size_t first, size_t count) {
  std::vector<Point2> points;
  for (size_t k = 0; k < count; ++k) points.push_back(ring.sides[(first + k) % ring.size()]);
  return {simplify_line(points, tolerance), ring.beyond[first], ring.label};
}

}  // namespace

std::vector<Bridge> find_bridges(const Image16& labels, const Image8& barrier, double line_width) {
  const auto shortest = static_cast<size_t>(std::max(3.0, line_width));
  std::vector<Bridge> bridges;
  for (const LabelRing& ring : trace_label_rings(labels)) {
    const std::vector<uint8_t> open = open_sides(ring, barrier);
    const auto go_on = [&](size_t i, size_t j) {
      return open[i] == open[j] && ring.beyond[i] == ring.beyond[j];
    };
    for_each_run(ring.size(), go_on, [&](size_t first, size_t count) {
      // Each boundary is traced twice, once for each label; the larger one's counts.
      if (open[first] != 0 && count >= shortest && ring.beyond[first] < ring.label)
        bridges.push_back(bridge_of(ring, first, count));
    });
  }
  return bridges;
}

}  // namespace relievo::understanding

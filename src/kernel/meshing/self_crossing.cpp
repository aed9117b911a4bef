#include "kernel/meshing/self_crossing.h"

#include <utility>
#include <vector>

#include "kernel/meshing/segment_grid.h"
#include "kernel/meshing/triangulate.h"

namespace relievo {
namespace {

using Segment = std::pair<Point2, Point2>;

bool cross_inside(const Segment& s, const Segment& t) {
  return orientation(s.first, s.second, t.first) * orientation(s.first, s.second, t.second) < 0 &&
         orientation(t.first, t.second, s.first) * orientation(t.first, t.second, s.second) < 0;
}

Point2 meeting_point(const Segment& s, const Segment& t) {
  const Point2 along = s.second - s.first;
  const Point2 other = t.second - t.first;
  return s.first + (cross(t.first - s.first, other) / cross(along, other)) * along;
}

}  // namespace

std::optional<Point2> find_self_crossing(const Outline& outline) {
  std::vector<Segment> edges;
  for (const Ring& ring : outline)
    for (size_t i = 0; i < ring.size(); ++i)
      edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  SegmentGrid grid(bounding_box(outline), edges.size());
  grid.build(edges.size(), [&](size_t e) { return edges[e]; });
  std::optional<Point2> found;
  for (size_t e = 0; e < edges.size() && !found; ++e)
    grid.for_cells(edges[e].first, edges[e].second, 0, [&](size_t cell) {
      for (const int* other = grid.begin(cell); other != grid.end(cell) && !found; ++other)
        if (cross_inside(edges[e], edges[*other])) found = meeting_point(edges[e], edges[*other]);
    });
  return found;
}

}  // namespace relievo

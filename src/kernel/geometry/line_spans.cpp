#include "kernel/geometry/line_spans.h"

#include <algorithm>

namespace relievo {
namespace {

/// Where a line crosses an outline, and by how much its winding number changes there.
struct Crossing {
  double s = 0;
  int turn = 0;
};

/// Appends the crossings of segment ab, which begins at arc length `start`. Ends belong to the
/// side that rounding puts them on, of the outline's edges and of the segment alike, so that a
/// crossing through a vertex counts once.
void add_crossings(Point2 a, Point2 b, double start, const Ring& ring,
                   std::vector<Crossing>& crossings) {
  const Point2 along = b - a;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 p = ring[i];
    const Point2 q = ring[(i + 1) % ring.size()];
    const bool left_p = cross(along, p - a) < 0;
    const bool left_q = cross(along, q - a) < 0;
    if (left_p == left_q) continue;
    const bool before = cross(q - p, a - p) < 0;
    const bool after = cross(q - p, b - p) < 0;
    if (before == after) continue;
    const double t = std::clamp(cross(p - a, q - p) / cross(along, q - p), 0.0, 1.0);
    crossings.push_back({start + t * norm(along), before ? 1 : -1});
  }
}

}  // namespace

std::vector<LineSpan> spans_inside(const std::vector<Point2>& line, const Outline& outline) {
  std::vector<Crossing> crossings;
  double length = 0;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    for (const Ring& ring : outline) add_crossings(line[i], line[i + 1], length, ring, crossings);
    length += distance(line[i], line[i + 1]);
  }
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.s < b.s; });
  int winding = 0;
  if (!line.empty())
    for (const Ring& ring : outline) winding += winding_number(ring, line[0]);
  std::vector<LineSpan> spans;
  double from = 0;
  const auto close = [&](double to) {
    if (winding != 0 && to > from) spans.push_back({from, to});
    from = to;
  };
  for (const Crossing& crossing : crossings) {
    if ((winding == 0) != (winding + crossing.turn == 0)) close(crossing.s);
    winding += crossing.turn;
  }
  close(length);
  return spans;
}

double line_length(const std::vector<Point2>& line) {
  double length = 0;
  for (size_t i = 0; i + 1 < line.size(); ++i) length += distance(line[i], line[i + 1]);
  return length;
}

Point2 point_on_line(const std::vector<Point2>& line, double s) {
  size_t i = 0;
  double length = distance(line[0], line[1]);
  while (s > length && i + 2 < line.size()) {
    s -= length;
    ++i;
    length = distance(line[i], line[i + 1]);
  }
  return line[i] + s / length * (line[i + 1] - line[i]);
}

}  // namespace relievo

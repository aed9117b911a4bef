#include "kernel/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "kernel/base/exact_functions.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

/// A crossing of a line with an outline.
struct LineCrossing {
  double s = 0;  ///< position along the line
  int turn = 0;  ///< change of the outline's winding number there, 1 or -1
};

/// Appends the crossings of segment ab, which begins at arc length `start`, with a ring. An end of
/// the segment or of an edge belongs to the side on which rounding puts it, so that a crossing
/// through a vertex counts once.
void add_crossings(Point2 a, Point2 b, double start, const Ring& ring,
                   std::vector<LineCrossing>& crossings) {
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

/// Appends the crossings of edge ab with the lines through the centres of the rows.
void add_row_crossings(Point2 a, Point2 b, const CellGrid& grid,
                       std::vector<std::vector<LineCrossing>>& rows) {
  const int turn = a.y < b.y ? 1 : -1;
  if (turn < 0) std::swap(a, b);
  const int last = first_centre((b.y - grid.origin.y) / grid.cell, grid.rows);
  for (int row = first_centre((a.y - grid.origin.y) / grid.cell, grid.rows); row < last; ++row) {
    const double t = (grid.origin.y + (row + 0.5) * grid.cell - a.y) / (b.y - a.y);
    rows[row].push_back({a.x + t * (b.x - a.x), turn});
  }
}

/// Returns a point outside the outline from which the first segment of the line is its
/// continuation.
Point2 far_before(const std::vector<Point2>& line, const Outline& outline) {
  Box2 box = bounding_box(outline);
  box.add(line[0]);
  size_t next = 1;
  while (next + 1 < line.size() && line[next] == line[0]) ++next;
  const Point2 along = line[next] - line[0];
  const double length = norm(along);
  return length > 0 ? line[0] - 2 * box.diagonal() / length * along : line[0];
}

/// Computes the length of a Bezier handle over that of the chord, given the angles at its own and
/// at the other end.
double handle(double own, double other) {
  const double sqrt5 = std::sqrt(5.0);
  const Point2 a = exact::direction_of(own);
  const Point2 b = exact::direction_of(other);
  const double bend = (a.y - b.y / 16) * (b.y - a.y / 16) * (a.x - b.x);
  const double spread = 3 * (1 + 0.5 * (sqrt5 - 1) * a.x + 0.5 * (3 - sqrt5) * b.x);
  // The denominator nears 0 where both ends point backwards. A handle above 3 chords makes a loop.
  return std::clamp((2 + std::sqrt(2.0) * bend) / std::max(spread, 1e-3), 0.05, 3.0);
}

}  // namespace

std::vector<LineSpan> spans_inside(const std::vector<Point2>& line, const Outline& outline) {
  if (line.size() < 2) return {};
  // The winding number at the first point follows from the same tests as all its changes, also
  // where that point is on the outline.
  const Point2 far = far_before(line, outline);
  std::vector<LineCrossing> crossings;
  for (const Ring& ring : outline)
    add_crossings(far, line[0], -distance(far, line[0]), ring, crossings);
  double length = 0;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    for (const Ring& ring : outline) add_crossings(line[i], line[i + 1], length, ring, crossings);
    length += distance(line[i], line[i + 1]);
  }
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const LineCrossing& a, const LineCrossing& b) { return a.s < b.s; });
  int winding = 0;
  std::vector<LineSpan> spans;
  double from = 0;
  const auto close = [&](double to) {
    if (winding != 0 && to > from) spans.push_back({from, to});
    from = std::max(from, to);
  };
  for (const LineCrossing& crossing : crossings) {
    if ((winding == 0) != (winding + crossing.turn == 0)) close(crossing.s);
    winding += crossing.turn;
  }
  close(length);
  return spans;
}

int first_centre(double v, int size) {
  return static_cast<int>(std::clamp(std::ceil(v - 0.5), 0.0, static_cast<double>(size)));
}

std::vector<CellRun> cells_inside(const Outline& outline, const CellGrid& grid) {
  std::vector<std::vector<LineCrossing>> rows(grid.rows);
  for (const Ring& ring : outline)
    for (size_t i = 0; i < ring.size(); ++i)
      add_row_crossings(ring[i], ring[(i + 1) % ring.size()], grid, rows);
  const auto column = [&](const LineCrossing& crossing) {
    return first_centre((crossing.s - grid.origin.x) / grid.cell, grid.columns);
  };
  std::vector<CellRun> runs;
  for (int y = 0; y < grid.rows; ++y) {
    std::sort(rows[y].begin(), rows[y].end(), [](const LineCrossing& p, const LineCrossing& q) {
      return p.s < q.s || (p.s == q.s && p.turn < q.turn);
    });
    int winding = 0;
    for (size_t i = 0; i + 1 < rows[y].size(); ++i) {
      winding += rows[y][i].turn;
      if (winding != 0) runs.push_back({y, column(rows[y][i]), column(rows[y][i + 1])});
    }
  }
  return runs;
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

std::vector<Point2> simplify_line(const std::vector<Point2>& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<uint8_t> keep(line.size(), 0);
  keep.front() = keep.back() = 1;
  std::vector<std::pair<size_t, size_t>> open = {{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    size_t farthest = a;
    double largest = tolerance;
    for (size_t i = a + 1; i < b; ++i) {
      const double d = distance_to_segment(line[i], line[a], line[b]);
      if (d <= largest) continue;
      largest = d;
      farthest = i;
    }
    if (farthest == a) continue;
    keep[farthest] = 1;
    open.emplace_back(a, farthest);
    open.emplace_back(farthest, b);
  }
  std::vector<Point2> few;
  for (size_t i = 0; i < line.size(); ++i)
    if (keep[i] != 0) few.push_back(line[i]);
  return few;
}

double turn_between(Point2 from, Point2 to) {
  return exact::angle_of(cross(from, to), dot(from, to));
}

double turning(const DirectedPoint& from, const DirectedPoint& to) {
  const Point2 chord = to.at - from.at;
  return turn_between(from.direction, chord) + turn_between(chord, to.direction);
}

std::vector<Point2> smooth_arc(const DirectedPoint& from, const DirectedPoint& to, double step) {
  const Point2 chord = to.at - from.at;
  const double length = norm(chord);
  if (length <= step) return {};
  const double start = turn_between(from.direction, chord);
  const double end = turn_between(chord, to.direction);
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

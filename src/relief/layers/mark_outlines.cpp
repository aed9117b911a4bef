#include "relief/layers/mark_outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernel/geometry/polyline.h"

namespace relievo::relief {
namespace {

/// Largest mean distance between a join's line and the outline that it follows, of the canvas
/// diagonal. Lines are drawn by eye.
constexpr double line_reach = 0.08;

/// Number of chords in which an arc is compared with a line.
constexpr int chords = 32;

/// Smallest diagonal of the box around a ring that is kept, of the detail.
constexpr double speck = 0.02;

/// Largest detail, of the diagonal of the drawing, so that a coarse mesh keeps whole parts.
constexpr double coarsest_detail = 0.01;

/// Marks that are nearer to each other are one, of the spacing. Ranges often begin where a join
/// ends, up to rounding, and two vertices 1e-13 px apart make the depth order insoluble.
constexpr double same_mark = 0.02;

/// Smallest distance between the ends of a join, of the length of the ring: more than rounding.
constexpr double shortest_join = 1e-6;

/// Edges wanted along a join, within the bounds below (of the spacing). Flat faces meet at an angle
/// that grows with their size, where one smooth surface is meant: with edges of one spacing, 8 of
/// 588 joins of random limbs were bent by more than 2 degrees at 48,000 vertices.
constexpr int fine_join_edges = 64;
constexpr double finest_at_join = 0.25;
constexpr double coarsest_at_join = 0.5;

Ring without_repeats(Ring ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

/// The arc from a forward to b, in chords.
std::vector<Point2> chords_of_arc(const MarkedRing& ring, double a, double b) {
  const double length = arc_forward(a, b, ring.measure.length);
  std::vector<Point2> arc;
  for (int i = 0; i <= chords; ++i)
    arc.push_back(point_at(ring.ring, ring.measure, a + length * i / chords));
  return arc;
}

/// Mean distance between the arc from a forward to b and the line, both ways.
double gap_to_line(const MarkedRing& ring, double a, double b, const std::vector<Point2>& line) {
  const std::vector<Point2> arc = chords_of_arc(ring, a, b);
  double sum = 0;
  for (const Point2 p : arc) sum += distance_to_polyline(line, p) / chords;
  for (const Point2 p : line)
    sum += distance_to_polyline(arc, p) / static_cast<double>(line.size());
  return sum;
}

/// Length of the arc inside the outline.
double length_inside(const MarkedRing& ring, const CurveRun& arc, const Outline& outline) {
  double length = 0;
  for (const LineSpan span : spans_inside(chords_of_arc(ring, arc.from, arc.to), outline))
    length += span.to - span.from;
  return length;
}

/// Returns the index of the part's ring that is nearest to the points on average, or -1 if it has
/// none, and the sum of the distances.
int nearest_ring(const std::vector<MarkedRing>& rings, int part, const std::vector<Point2>& points,
                 double& gap) {
  int best = -1;
  gap = std::numeric_limits<double>::infinity();
  for (size_t r = 0; r < rings.size(); ++r) {
    if (rings[r].part != part || rings[r].ring.size() < 3) continue;
    double sum = 0;
    for (const Point2 p : points)
      sum += nearest_on_ring(rings[r].ring, rings[r].measure, p).distance;
    if (sum >= gap) continue;
    gap = sum;
    best = static_cast<int>(r);
  }
  return best;
}

/// Returns the place on the ring nearest to p, or the mark that is already there.
double mark_near(const MarkedRing& ring, Point2 p, double spacing) {
  const double s = nearest_on_ring(ring.ring, ring.measure, p).s;
  for (const double mark : ring.marks)
    if (arc_distance(s, mark, ring.measure.length) < same_mark * spacing) return mark;
  return s;
}

/// Makes the run between two places on a ring and marks both: from `first` forward to `second`, or
/// the other way if `reversed`.
CurveRun mark_run(int curve, double first, double second, bool reversed, MarkedRing& ring) {
  const double from = reversed ? second : first;
  const double to = reversed ? first : second;
  ring.marks.push_back(from);
  ring.marks.push_back(to);
  return {curve, from, to, reversed, arc_forward(from, to, ring.measure.length)};
}

void mark_rings(const Scene& scene, MarkedOutlines& out) {
  for (size_t p = 0; p < scene.parts.size(); ++p) {
    int specks = 0;
    for (const Ring& ring : scene.parts[p].outline) {
      MarkedRing marked{static_cast<int>(p), without_repeats(ring), {}, {}};
      if (bounding_box(marked.ring).diagonal() < speck * out.detail) {
        marked.ring.clear();
        ++specks;
      }
      marked.measure = measure(marked.ring);
      out.rings.push_back(std::move(marked));
    }
    if (specks > 0)
      out.warnings.push_back("parts[" + std::to_string(p) + "] (\"" + scene.parts[p].id +
                             "\"): " + std::to_string(specks) +
                             " of its rings are too small for this resolution and left out");
  }
}

Status mark_join(const Scene& scene, size_t j, double spacing, MarkedOutlines& out) {
  const Join& join = scene.joins[j];
  const Culprit culprit{CulpritList::joins, j};
  const std::string where = to_string(culprit) + ".line";
  const std::string& upper = scene.parts[join.upper].id;
  const double diagonal = std::hypot(scene.width, scene.height);
  double gap = 0;
  const int best = nearest_ring(out.rings, join.upper, join.line, gap);
  if (best < 0 || gap / static_cast<double>(join.line.size()) > line_reach * diagonal)
    return Error{ErrorCode::bad_input,
                 "the join's line is far from the outline of \"" + upper +
                     "\"; draw it along that outline, where it lies inside the lower part",
                 where, culprit};
  MarkedRing& ring = out.rings[best];
  const double a = mark_near(ring, join.line.front(), spacing);
  const double b = mark_near(ring, join.line.back(), spacing);
  if (arc_distance(a, b, ring.measure.length) < shortest_join * ring.measure.length)
    return Error{ErrorCode::bad_input,
                 "both ends of the join meet the outline of \"" + upper + "\" at one point", where,
                 culprit};
  const bool reversed = gap_to_line(ring, a, b, join.line) > gap_to_line(ring, b, a, join.line);
  out.joins.push_back(mark_run(best, a, b, reversed, ring));
  const double inside = length_inside(ring, out.joins.back(), scene.parts[join.lower].outline);
  out.join_spacing.push_back(
      std::clamp(inside / fine_join_edges, finest_at_join * spacing, coarsest_at_join * spacing));
  return Done{};
}

/// Marks a range of the part's outline: the shorter way between its ends, or from `from` forward.
CurveRun mark_range(int part, Point2 from, Point2 to, bool shorter, double spacing,
                    MarkedOutlines& out) {
  double gap = 0;
  const int best = nearest_ring(out.rings, part, {from, to}, gap);
  if (best < 0) return {};
  MarkedRing& ring = out.rings[best];
  const double a = mark_near(ring, from, spacing);
  const double b = mark_near(ring, to, spacing);
  const double length = ring.measure.length;
  return mark_run(best, a, b, shorter && arc_forward(a, b, length) > 0.5 * length, ring);
}

}  // namespace

double arc_forward(double from, double to, double length) {
  const double d = std::fmod(to - from, length);
  return d < 0 ? d + length : d;
}

double arc_distance(double a, double b, double length) {
  const double ahead = arc_forward(a, b, length);
  return std::min(ahead, length - ahead);
}

Result<MarkedOutlines> mark_outlines(const Scene& scene, double spacing) {
  Box2 box;
  for (const Part& part : scene.parts) box.add(bounding_box(part.outline));
  MarkedOutlines out;
  out.detail = std::min(spacing, coarsest_detail * box.diagonal());
  mark_rings(scene, out);
  for (size_t j = 0; j < scene.joins.size(); ++j)
    if (Status status = mark_join(scene, j, spacing, out); !status) return status.error();
  for (const RobinRange& range : scene.robin)
    out.robin.push_back(mark_range(range.upper, range.from, range.to, true, spacing, out));
  for (const Relation& relation : scene.relations)
    if (relation.range)
      out.relation_ranges.push_back(mark_range(relation.upper, relation.range->first,
                                               relation.range->second, false, spacing, out));
  return out;
}

}  // namespace relievo::relief

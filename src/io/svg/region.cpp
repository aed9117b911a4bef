#include "io/svg/region.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <polyclipping/clipper.hpp>
#include <utility>

namespace relievo {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

constexpr double units_per_px = 1024;
constexpr double arc_tolerance = 0.05;  // px

Path to_path(const Ring& ring) {
  Path path;
  path.reserve(ring.size());
  for (const Point2 p : ring) {
    path.emplace_back(std::llround(p.x * units_per_px), std::llround(p.y * units_per_px));
  }
  return path;
}

Paths to_paths(const Region& region) {
  Paths paths;
  paths.reserve(region.size());
  for (const Ring& ring : region) paths.push_back(to_path(ring));
  return paths;
}

Region to_region(const Paths& paths) {
  Region region;
  for (const Path& path : paths) {
    if (path.size() < 3) continue;
    Ring ring;
    ring.reserve(path.size());
    for (const IntPoint& p : path) {
      ring.push_back(
          {static_cast<double>(p.X) / units_per_px, static_cast<double>(p.Y) / units_per_px});
    }
    region.push_back(std::move(ring));
  }
  return region;
}

ClipperLib::PolyFillType fill_type(FillRule rule) {
  return rule == FillRule::even_odd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
}

Paths combine(ClipperLib::ClipType operation, const Paths& subject, const Paths& clip,
              FillRule rule = FillRule::nonzero, bool simple = false) {
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(simple);
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  Paths result;
  clipper.Execute(operation, result, fill_type(rule), ClipperLib::pftNonZero);
  return result;
}

bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

Ring box_ring(const Box2& box) {
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

/// Cuts a closed ring at one side of a box (Sutherland and Hodgman): winding numbers inside the
/// side stay as they were. `depth` is positive inside.
template <class Depth>
Ring cut_at(const Ring& ring, const Depth& depth) {
  Ring kept;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i];
    const Point2 b = ring[(i + 1) % ring.size()];
    const double da = depth(a);
    const double db = depth(b);
    if (da >= 0) kept.push_back(a);
    if ((da >= 0) != (db >= 0)) kept.push_back(a + (da / (da - db)) * (b - a));
  }
  return kept;
}

Ring cut_to_box(Ring ring, const Box2& box) {
  ring = cut_at(ring, [&](Point2 p) { return p.x - box.min.x; });
  ring = cut_at(ring, [&](Point2 p) { return box.max.x - p.x; });
  ring = cut_at(ring, [&](Point2 p) { return p.y - box.min.y; });
  return cut_at(ring, [&](Point2 p) { return box.max.y - p.y; });
}

Box2 inflated(const Box2& box, double margin) {
  return {{box.min.x - margin, box.min.y - margin}, {box.max.x + margin, box.max.y + margin}};
}

/// The part of the segment inside the box as parameters [first, second], or nothing.
std::optional<std::pair<double, double>> segment_inside(Point2 a, Point2 b, const Box2& box) {
  double from = 0;
  double to = 1;
  const auto clip = [&](double start, double step, double low, double high) {
    if (step == 0) return start >= low && start <= high;
    const double t0 = (low - start) / step;
    const double t1 = (high - start) / step;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
    return from <= to;
  };
  if (!clip(a.x, b.x - a.x, box.min.x, box.max.x)) return std::nullopt;
  if (!clip(a.y, b.y - a.y, box.min.y, box.max.y)) return std::nullopt;
  return std::make_pair(from, to);
}

/// The runs of a line inside the box; a line wholly inside stays whole and closed.
std::vector<Polyline> runs_inside(const Polyline& line, const Box2& box) {
  const auto inside = [&](Point2 p) {
    return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
  };
  if (std::all_of(line.points.begin(), line.points.end(), inside)) return {line};
  std::vector<Polyline> runs;
  const size_t n = line.points.size();
  for (size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
    const Point2 a = line.points[i];
    const Point2 b = line.points[(i + 1) % n];
    const auto range = segment_inside(a, b, box);
    if (!range) continue;
    const Point2 first = a + range->first * (b - a);
    if (runs.empty() || !(runs.back().points.back() == first)) runs.push_back({{first}, false});
    runs.back().points.push_back(a + range->second * (b - a));
  }
  return runs;
}

ClipperLib::JoinType join_type(LineJoin join) {
  if (join == LineJoin::round) return ClipperLib::jtRound;
  return join == LineJoin::bevel ? ClipperLib::jtSquare : ClipperLib::jtMiter;
}

ClipperLib::EndType end_type(const Polyline& line, LineCap cap) {
  if (line.closed) return ClipperLib::etClosedLine;
  if (cap == LineCap::round) return ClipperLib::etOpenRound;
  return cap == LineCap::square ? ClipperLib::etOpenSquare : ClipperLib::etOpenButt;
}

}  // namespace

Region fill_region(const std::vector<Polyline>& lines, FillRule rule, const Box2& bounds) {
  Paths paths;
  for (const Polyline& line : lines) {
    if (line.points.size() < 3) continue;
    if (!std::all_of(line.points.begin(), line.points.end(), is_finite)) continue;
    paths.push_back(to_path(cut_to_box(line.points, inflated(bounds, 1))));
  }
  return to_region(combine(ClipperLib::ctIntersection, paths, {to_path(box_ring(bounds))}, rule));
}

Region stroke_region(const std::vector<Polyline>& lines, const StrokeShape& shape,
                     const Box2& bounds) {
  const double half = shape.width / 2;
  if (!(half > 0) || !(half < 1e5)) return {};
  const double reach = half * (shape.join == LineJoin::miter ? shape.miter_limit : 1) + half;
  const Box2 near = inflated(bounds, std::min(reach, 1e5));
  ClipperLib::ClipperOffset offset(std::min(shape.miter_limit, 100.0),
                                   arc_tolerance * units_per_px);
  for (const Polyline& line : lines) {
    if (!std::all_of(line.points.begin(), line.points.end(), is_finite)) continue;
    for (const Polyline& run : runs_inside(line, near)) {
      offset.AddPath(to_path(run.points), join_type(shape.join), end_type(run, shape.cap));
    }
  }
  Paths covered;
  offset.Execute(covered, half * units_per_px);
  return to_region(combine(ClipperLib::ctIntersection, covered, {to_path(box_ring(bounds))}));
}

Region unite(const Region& p, const Region& q) {
  return to_region(combine(ClipperLib::ctUnion, to_paths(p), to_paths(q)));
}

Region unite(const std::vector<Region>& regions) {
  // In rounds of pairs, for what lies inside drops out early.
  std::vector<Paths> round;
  for (const Region& region : regions) round.push_back(to_paths(region));
  while (round.size() > 1) {
    for (size_t i = 0; 2 * i < round.size(); ++i) {
      const Paths second = 2 * i + 1 < round.size() ? round[2 * i + 1] : Paths();
      round[i] = combine(ClipperLib::ctUnion, round[2 * i], second);
    }
    round.resize((round.size() + 1) / 2);
  }
  return round.empty() ? Region() : to_region(combine(ClipperLib::ctUnion, round[0], {}));
}

Region intersect(const Region& p, const Region& q) {
  if (p.empty() || q.empty()) return {};
  return to_region(combine(ClipperLib::ctIntersection, to_paths(p), to_paths(q)));
}

Region subtract(const Region& p, const Region& q) {
  if (p.empty()) return {};
  return to_region(combine(ClipperLib::ctDifference, to_paths(p), to_paths(q)));
}

Region grow(const Region& region, double distance) {
  ClipperLib::ClipperOffset offset(2, arc_tolerance * units_per_px);
  offset.AddPaths(to_paths(region), ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  Paths result;
  offset.Execute(result, distance * units_per_px);
  return to_region(result);
}

bool boxes_meet(const Box2& p, const Box2& q) {
  return p.min.x <= q.max.x && q.min.x <= p.max.x && p.min.y <= q.max.y && q.min.y <= p.max.y;
}

double area(const Region& region) {
  double sum = 0;
  for (const Ring& ring : region) sum += signed_area(ring);
  return sum;
}

std::vector<Region> pieces(const Region& region) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(to_paths(region), ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  std::vector<Region> result;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node; node = node->GetNext()) {
    if (node->IsHole()) continue;
    Paths paths = {node->Contour};
    for (const ClipperLib::PolyNode* hole : node->Childs) paths.push_back(hole->Contour);
    result.push_back(to_region(paths));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Region& p, const Region& q) { return area(p) > area(q); });
  return result;
}

Region without_holes(const Region& region) {
  Region outer;
  for (const Ring& ring : region) {
    if (signed_area(ring) > 0) outer.push_back(ring);
  }
  return unite({outer});
}

Region tidied(const Region& region, double tolerance, double min_area) {
  Paths paths = to_paths(region);
  ClipperLib::CleanPolygons(paths, tolerance * units_per_px);
  const Region clean = to_region(combine(ClipperLib::ctUnion, paths, {}, FillRule::nonzero, true));
  Region kept;
  for (const Ring& ring : clean) {
    if (std::abs(signed_area(ring)) >= min_area) kept.push_back(ring);
  }
  return kept;
}

}  // namespace relievo

#include "io/svg/svg_region.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "kernel/geometry/clipper_paths.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

ClipperLib::PolyFillType fill_type(FillRule rule) {
  return rule == FillRule::even_odd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
}

bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

Ring box_ring(const Box2& box) {
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

/// Cuts a closed ring at one side of a box (Sutherland and Hodgman), which keeps winding numbers
/// inside. `depth` is positive inside.
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

/// Returns the part of the segment inside the box as parameters [first, second], or nothing.
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

/// Returns the runs of a line inside the box; a line wholly inside stays whole and closed.
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

constexpr int cells = 64;

/// Adds the segment from a to b to the counts of the cells that it runs through, row by row; in
/// each row it covers a run of columns. Coordinates are in cells from the grid's corner.
void count_cells(Point2 a, Point2 b, std::vector<double>& counts) {
  const auto cell = [](double value) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, cells - 1.0));
  };
  if (a.y > b.y) std::swap(a, b);
  const auto x_at = [&](int row) {
    return a.x + std::clamp((row - a.y) / (b.y - a.y), 0.0, 1.0) * (b.x - a.x);
  };
  const int first = cell(a.y);
  const int last = cell(b.y);
  for (int y = first; y <= last; ++y) {
    const double x0 = y == first ? a.x : x_at(y);
    const double x1 = y == last ? b.x : x_at(y + 1);
    for (int x = cell(std::min(x0, x1)); x <= cell(std::max(x0, x1)); ++x) ++counts[y * cells + x];
  }
}

}  // namespace

Polyline rectangle_line(const Box2& box, const Affine2& map) {
  return {{map(box.min), map({box.max.x, box.min.y}), map(box.max), map({box.min.x, box.max.y})},
          true};
}

std::vector<Polyline> mapped(std::vector<Polyline> lines, const Affine2& map) {
  for (Polyline& line : lines)
    for (Point2& p : line.points) p = map(p);
  return lines;
}

Region mapped_region(const Region& region, const Affine2& map, const Box2& bounds) {
  std::vector<Polyline> lines;
  for (const Ring& ring : region) lines.push_back({ring, true});
  return fill_region(mapped(std::move(lines), map), FillRule::nonzero, bounds);
}

Region fill_region(const std::vector<Polyline>& lines, FillRule rule, const Box2& bounds) {
  ClipperLib::Paths paths;
  for (const Polyline& line : lines) {
    if (line.points.size() < 3) continue;
    if (!std::all_of(line.points.begin(), line.points.end(), is_finite)) continue;
    paths.push_back(to_path(cut_to_box(line.points, inflated(bounds, 1))));
  }
  return to_region(
      combine(ClipperLib::ctIntersection, paths, {to_path(box_ring(bounds))}, fill_type(rule)));
}

Region stroke_region(const std::vector<Polyline>& lines, const StrokeShape& shape,
                     const Box2& bounds) {
  const double half = shape.width / 2;
  if (!(half > 0) || !(half < 1e5)) return {};
  const double reach = half * (shape.join == LineJoin::miter ? shape.miter_limit : 1) + half;
  const Box2 near = inflated(bounds, std::min(reach, 1e5));
  ClipperLib::ClipperOffset offset(std::min(shape.miter_limit, 100.0), clipper_arc_tolerance);
  for (const Polyline& line : lines) {
    if (!std::all_of(line.points.begin(), line.points.end(), is_finite)) continue;
    for (const Polyline& run : runs_inside(line, near)) {
      offset.AddPath(to_path(run.points), join_type(shape.join), end_type(run, shape.cap));
    }
  }
  ClipperLib::Paths covered;
  offset.Execute(covered, half * clipper_units_per_px);
  return to_region(combine(ClipperLib::ctIntersection, covered, {to_path(box_ring(bounds))}));
}

double tangle(const std::vector<Polyline>& lines) {
  Box2 box;
  for (const Polyline& line : lines) box.add(bounding_box(line.points));
  if (box.empty()) return 0;
  const Point2 scale{cells / std::max(1e-9, box.max.x - box.min.x),
                     cells / std::max(1e-9, box.max.y - box.min.y)};
  const auto in_cells = [&](Point2 p) {
    return Point2{(p.x - box.min.x) * scale.x, (p.y - box.min.y) * scale.y};
  };
  std::vector<double> counts(size_t{cells} * cells);
  for (const Polyline& line : lines) {
    const size_t n = line.points.size();
    for (size_t i = 0; i < n; ++i)
      count_cells(in_cells(line.points[i]), in_cells(line.points[(i + 1) % n]), counts);
  }
  return std::inner_product(counts.begin(), counts.end(), counts.begin(), 0.0);
}

}  // namespace relievo

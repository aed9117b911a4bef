#include "solid/plate_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/geometry/clipper_paths.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

constexpr double arc_tolerance = 0.02;  ///< mm between a circle and its chords, at most
constexpr double hole_wall = 1.5;       ///< mm of plate around a hole, at least

Paths on_grid(const Outline& outline) {
  Paths paths;
  for (const Ring& ring : outline) {
    Path& path = paths.emplace_back();
    for (const Point2 p : ring) path.emplace_back(std::llround(p.x), std::llround(p.y));
  }
  return paths;
}

Paths combined(ClipperLib::ClipType operation, const Paths& subject, const Paths& clip) {
  return combine(operation, subject, clip, ClipperLib::pftNonZero, true);
}

Paths offset(const Paths& paths, double distance, double mm) {
  return combined(ClipperLib::ctUnion, grow_paths(paths, distance, arc_tolerance * mm), {});
}

Path circle(Point2 centre, double radius, double mm) {
  const double step = 2 * std::acos(1 - std::min(0.5, arc_tolerance * mm / radius));
  const int count = std::max(12, static_cast<int>(std::ceil(2 * std::numbers::pi / step)));
  Path path;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    path.emplace_back(std::llround(centre.x + radius * std::cos(angle)),
                      std::llround(centre.y + radius * std::sin(angle)));
  }
  return path;
}

/// Returns the rings that no other surrounds.
Paths without_holes(const Paths& paths) {
  Paths outer;
  for (const Path& path : paths)
    if (ClipperLib::Orientation(path)) outer.push_back(path);
  return outer;
}

Paths rectangle(const Box2& box, const SolidOptions& options, double mm) {
  const Point2 sides = box.max - box.min;
  const double margin = options.margin * mm;
  const double half = 0.5 * std::min(sides.x, sides.y) + margin;
  const double corner = std::min(options.corner * mm, 0.999 * half);
  const double inset = margin - corner;
  const auto grid = [](double v) { return std::llround(v); };
  const Paths inner{{{grid(box.min.x - inset), grid(box.min.y - inset)},
                     {grid(box.max.x + inset), grid(box.min.y - inset)},
                     {grid(box.max.x + inset), grid(box.max.y + inset)},
                     {grid(box.min.x - inset), grid(box.max.y + inset)}}};
  return corner < arc_tolerance * mm ? inner : offset(inner, corner, mm);
}

Paths disc(const Outline& silhouette, Point2 centre, double margin, double mm) {
  double radius = 0;
  for (const Ring& ring : silhouette)
    for (const Point2 p : ring) radius = std::max(radius, distance(p, centre));
  // Its chords must not come nearer than the margin.
  return {circle(centre, radius + margin + arc_tolerance * mm, mm)};
}

Paths plate(const Outline& silhouette, const SolidOptions& options, double mm) {
  const Box2 box = bounding_box(silhouette);
  if (options.base == BaseShape::plate) return rectangle(box, options, mm);
  if (options.base == BaseShape::round)
    return disc(silhouette, 0.5 * (box.min + box.max), options.margin * mm, mm);
  return without_holes(offset(on_grid(silhouette), options.margin * mm, mm));
}

/// Returns a high point of the paths; distance from the middle counts half as much as height.
ClipperLib::IntPoint top_of(const Paths& paths, double middle) {
  ClipperLib::IntPoint best = paths.front().front();
  const auto rank = [middle](const ClipperLib::IntPoint& p) {
    return static_cast<double>(p.Y) - 0.5 * std::abs(static_cast<double>(p.X) - middle);
  };
  for (const Path& path : paths)
    for (const ClipperLib::IntPoint& p : path)
      if (rank(p) > rank(best)) best = p;
  return best;
}

Point2 as_point(const ClipperLib::IntPoint& p) {
  return {static_cast<double>(p.X), static_cast<double>(p.Y)};
}

Status drill(const Outline& silhouette, double diameter, double mm, Paths& plate) {
  const Box2 box = bounding_box(silhouette);
  const double clear = (0.5 * diameter + hole_wall) * mm;
  const Paths room = combined(ClipperLib::ctDifference, offset(plate, -clear, mm),
                              offset(on_grid(silhouette), clear, mm));
  if (room.empty())
    return Error{ErrorCode::usage,
                 "the base has no room for the hole; use a wider margin, or a ring", "--hole"};
  const Point2 centre = as_point(top_of(room, 0.5 * (box.min.x + box.max.x)));
  plate = combined(ClipperLib::ctDifference, plate, {circle(centre, 0.5 * diameter * mm, mm)});
  return Done{};
}

/// Adds a loop whose hole begins at the top of the plate and whose rim reaches into the plate.
void add_loop(const Outline& silhouette, double diameter, double mm, Paths& plate) {
  const Box2 box = bounding_box(silhouette);
  const Point2 top = as_point(top_of(plate, 0.5 * (box.min.x + box.max.x)));
  const double radius = 0.5 * diameter * mm;
  const Point2 centre{top.x, top.y + radius};
  plate = combined(ClipperLib::ctUnion, plate, {circle(centre, radius + hole_wall * mm, mm)});
  plate = combined(ClipperLib::ctDifference, plate, {circle(centre, radius, mm)});
}

}  // namespace

Result<Outline> plate_outline(const Outline& silhouette, const SolidOptions& options, double mm) {
  Paths paths = plate(silhouette, options, mm);
  if (options.hole > 0)
    if (Status status = drill(silhouette, options.hole, mm, paths); !status) return status.error();
  if (options.ring > 0) add_loop(silhouette, options.ring, mm, paths);
  Outline outline;
  for (const Path& path : paths) {
    Ring& ring = outline.emplace_back();
    for (const ClipperLib::IntPoint& p : path) ring.push_back(as_point(p));
  }
  return outline;
}

}  // namespace relievo

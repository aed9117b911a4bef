#pragma once

#include <vector>

#include "io/svg/path_data.h"
#include "io/svg/svg_style.h"
#include "kernel/geometry/polygon.h"

namespace relievo {

/// Plane regions as outlines whose rings do not cross: outer rings of positive area, holes
/// negative. All results of the functions below are such; coordinates are rounded to 1/1024 px.
using Region = Outline;

/// How a line is stroked, in canvas px.
struct StrokeShape {
  double width = 1;
  LineCap cap = LineCap::butt;
  LineJoin join = LineJoin::miter;
  double miter_limit = 4;
};

/// What the lines enclose inside `bounds`. Coordinates up to 1e9 px are cut there without harm.
Region fill_region(const std::vector<Polyline>& lines, FillRule rule, const Box2& bounds);

/// What the pen covers inside `bounds`. Dashes are drawn as if solid.
Region stroke_region(const std::vector<Polyline>& lines, const StrokeShape& shape,
                     const Box2& bounds);

Region unite(const Region& p, const Region& q);
Region unite(const std::vector<Region>& regions);
Region intersect(const Region& p, const Region& q);
Region subtract(const Region& p, const Region& q);

/// The points nearer than `distance` to the region; with a negative one, those inside it that are
/// farther than -distance from its outside. Round corners.
Region grow(const Region& region, double distance);

/// Whether the closed boxes have a point in common.
bool boxes_meet(const Box2& p, const Box2& q);

/// Sum of the rings' signed areas, px^2.
double area(const Region& region);

/// The connected pieces, each with its holes, the largest first.
std::vector<Region> pieces(const Region& region);

/// The region with its holes filled.
Region without_holes(const Region& region);

/// Drops rings below `min_area` and points that change the outline by less than `tolerance`; no
/// two points of the result coincide.
Region tidied(const Region& region, double tolerance, double min_area);

}  // namespace relievo

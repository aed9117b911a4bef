#pragma once

#include <vector>

#include "io/svg/path_data.h"
#include "io/svg/svg_style.h"
#include "kernel/geometry/region.h"

namespace relievo {

/// The pen of a stroke, in canvas px.
struct StrokeShape {
  double width = 1;
  LineCap cap = LineCap::butt;
  LineJoin join = LineJoin::miter;
  double miter_limit = 4;
};

/// Returns the outline of a box under a map.
Polyline rectangle_line(const Box2& box, const Affine2& map);

/// Returns the lines under a map.
std::vector<Polyline> mapped(std::vector<Polyline> lines, const Affine2& map);

/// Returns the area inside `bounds` of a region under a map.
Region mapped_region(const Region& region, const Affine2& map, const Box2& bounds);

/// Returns the area inside `bounds` that the lines enclose. Coordinates may be as large as 1e9 px.
Region fill_region(const std::vector<Polyline>& lines, FillRule rule, const Box2& bounds);

/// Returns the area inside `bounds` that the pen covers. Dashes count as solid lines.
Region stroke_region(const std::vector<Polyline>& lines, const StrokeShape& shape,
                     const Box2& bounds);

/// Estimates the work that a region of these lines takes: the number of pairs of segments that
/// share a cell of a 64 x 64 grid over their box, summed over the cells. A smooth outline of n
/// points has at most about n^2 / 100, a scribble over the whole box about n^2. Precondition:
/// finite coordinates. O(cells touched).
double tangle(const std::vector<Polyline>& lines);

}  // namespace relievo

#pragma once

#include <vector>

#include "io/svg/path_data.h"
#include "io/svg/svg_style.h"
#include "kernel/geometry/region.h"

namespace relievo {

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

/// How much the lines run over each other, as an estimate of the work that a region of them
/// takes: pairs of segments that share a cell of a 64 x 64 grid over their box, summed over the
/// cells. A smooth outline of n points has about n^2 / 100 at most; a scribble over the whole box
/// has about n^2. Preconditions: finite coordinates. O(cells touched).
double tangle(const std::vector<Polyline>& lines);

}  // namespace relievo

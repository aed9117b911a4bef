#pragma once

#include <array>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// Simplifies triangles to about `count`. Edges are collapsed where quadrics say that the surface
/// changes least (libmeshoptimizer); vertices stay where they are or vanish. Open edges are
/// collapsed along themselves alone, for which more triangles may remain. The surface moves by
/// about `most_error` at most, in the units of positions. Returns the triangles left. Positions are
/// rounded to single precision. O(n log n).
std::vector<std::array<int, 3>> simplify_triangles(const std::vector<Point3>& positions,
                                                   const std::vector<std::array<int, 3>>& triangles,
                                                   size_t count, double most_error);

}  // namespace relievo

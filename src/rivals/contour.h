#pragma once

#include <array>
#include <vector>

#include "relievo/point.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "rivals/convolution.h"

namespace relievo {

/// Triangles in space.
struct TriangleSurface {
  std::vector<Point3> positions;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// The surface on which a convolution is 1, closed and manifold, by CGAL's Delaunay refinement of
/// surfaces: triangles within circles of `cell` times the radius of the bones there, at least
/// `smallest` (> 0). Refinement begins at every bone, so that no piece is missed. Fails with limit
/// where there are more than two million triangles, or interrupted.
Result<TriangleSurface> contour(const Convolution& convolution, double cell, double smallest,
                                const RunContext& context = {});

}  // namespace relievo

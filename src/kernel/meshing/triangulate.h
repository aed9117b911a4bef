#pragma once

#include <array>
#include <vector>

#include "relievo/point.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// A triangulation of the convex hull of its points.
struct PlanarTriangulation {
  std::vector<std::array<int, 3>> triangles;  ///< #T, positive signed area
  /// #T, for each corner k the triangle across the opposite edge, or -1 on the hull.
  std::vector<std::array<int, 3>> neighbours;
};

/// Computes the constrained Delaunay triangulation. Preconditions: points are distinct; edges do
/// not cross and contain no points other than their ends. Triangles are sorted, so that the result
/// depends on the input only. Fails with interrupted where `context` is cancelled, and with
/// internal where a precondition is violated. O(n log n).
Result<PlanarTriangulation> triangulate(const std::vector<Point2>& points,
                                        const std::vector<std::array<int, 2>>& edges,
                                        const RunContext& context = {});

/// Computes the exact sign of the signed area of triangle abc: 1, 0 or -1.
int orientation(Point2 a, Point2 b, Point2 c);

}  // namespace relievo

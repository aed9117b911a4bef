#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/meshing/triangulate.h"

namespace relievo::relief {

/// Which parts cover each triangle of a base triangulation.
struct Cover {
  std::vector<int> stack_begin;  ///< #T+1
  std::vector<int> stack_part;   ///< parts of each triangle, ascending (back to front)
};

/// Winding numbers by flood fill over the triangulation: crossing an edge changes them by the
/// loops that run along it; a part covers a triangle where its sum is not 0. `loop_part` names
/// the part of each loop; the loops' edges are edges of the triangulation. O(T + edges * log).
Cover cover_triangles(const PlanarTriangulation& base, const std::vector<std::vector<int>>& loops,
                      const std::vector<int>& loop_part);

/// Uncovers what hangs together of a part but has less area than `least`, px^2. O(T + faces).
void drop_specks(const PlanarTriangulation& base, const std::vector<Point2>& points, double least,
                 Cover& cover);

}  // namespace relievo::relief

#pragma once

#include <array>
#include <span>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// A view of triangles in the plane. Sheets may overlap: only the indices say what is connected.
struct FlatMesh {
  std::span<const Point2> positions;              ///< #N
  std::span<const std::array<int, 3>> triangles;  ///< #F, positive area cross(b - a, c - a) / 2
};

/// Which triangles meet at a node, as flat arrays: the corners of node n are
/// corner[begin[n]] .. corner[begin[n + 1] - 1], each as 3 * triangle + corner, ascending.
struct NodeCorners {
  std::vector<int> begin;   ///< #N + 1
  std::vector<int> corner;  ///< 3 #F
};

/// Lists the corners at each node. O(N + F).
NodeCorners corners_at_nodes(const FlatMesh& mesh);

/// Area of each triangle, #F.
std::vector<double> triangle_areas(const FlatMesh& mesh);

}  // namespace relievo

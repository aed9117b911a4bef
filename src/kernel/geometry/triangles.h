#pragma once

#include <array>
#include <span>
#include <vector>

#include "relievo/point.h"

namespace relievo {

using Triangle = std::array<int, 3>;  ///< nodes, counter-clockwise where areas are positive

/// Corner k of triangle t as one number, 3 t + k. The edge opposite to it runs from corner k + 1 to
/// corner k + 2 of the triangle.
using Corner = int;

constexpr Corner corner_of(int triangle, int k) { return 3 * triangle + k; }
constexpr int triangle_of(Corner corner) { return corner / 3; }
/// Which corner of its triangle it is.
constexpr int place_of(Corner corner) { return corner % 3; }
/// Of the corner at place k, the place of the next one in its triangle, and of the one after that.
constexpr int next_place(int k) { return (k + 1) % 3; }
constexpr int last_place(int k) { return (k + 2) % 3; }

/// The place of a node in a triangle that has it.
constexpr int place_of_node(const Triangle& triangle, int node) {
  return triangle[0] == node ? 0 : triangle[1] == node ? 1 : 2;
}

/// Whether the edge of `a` opposite to place i is the edge of `b` opposite to place j, seen from
/// the other side.
constexpr bool share_edge(const Triangle& a, int i, const Triangle& b, int j) {
  return a[next_place(i)] == b[last_place(j)] && a[last_place(i)] == b[next_place(j)];
}

/// A view of triangles in the plane. Sheets may overlap: only the indices say what is connected.
struct FlatMesh {
  std::span<const Point2> positions;    ///< #N
  std::span<const Triangle> triangles;  ///< #F, positive area cross(b - a, c - a) / 2
};

/// The corners at each node, ascending, as flat arrays.
struct NodeCorners {
  std::vector<int> begin;      ///< #N + 1
  std::vector<Corner> corner;  ///< 3 #F

  std::span<const Corner> at(int node) const {
    return {corner.data() + begin[node], corner.data() + begin[node + 1]};
  }
};

/// Lists the corners at each of `nodes` nodes. O(N + F).
NodeCorners corners_at_nodes(std::span<const Triangle> triangles, size_t nodes);

/// Area of each triangle, #F.
std::vector<double> triangle_areas(const FlatMesh& mesh);

/// What hangs together: of each of `nodes` nodes the smallest node of its piece. Near-linear.
std::vector<int> connected_pieces(std::span<const Triangle> triangles, size_t nodes);

}  // namespace relievo

#pragma once

#include <array>
#include <span>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// The nodes of a triangle in the order that gives it positive area.
using Triangle = std::array<int, 3>;

/// Corner k of triangle t as one number, 3 t + k. The edge opposite to it runs from corner k + 1 to
/// corner k + 2 of the triangle, modulo 3.
using Corner = int;

constexpr Corner corner_of(int triangle, int k) { return 3 * triangle + k; }
constexpr int triangle_of(Corner corner) { return corner / 3; }
/// Returns the index of a corner in its triangle, 0 to 2.
constexpr int place_of(Corner corner) { return corner % 3; }
/// Return the index of the corner after corner k of a triangle, and of the one before it.
constexpr int next_place(int k) { return (k + 1) % 3; }
constexpr int last_place(int k) { return (k + 2) % 3; }

/// Returns the index of the corner at a node. Precondition: the triangle has the node.
constexpr int place_of_node(const Triangle& triangle, int node) {
  return triangle[0] == node ? 0 : triangle[1] == node ? 1 : 2;
}

/// Returns whether the edge of `a` opposite to corner i is the edge of `b` opposite to corner j, in
/// the other direction.
constexpr bool share_edge(const Triangle& a, int i, const Triangle& b, int j) {
  return a[next_place(i)] == b[last_place(j)] && a[last_place(i)] == b[next_place(j)];
}

/// A view of triangles in the plane. They may overlap: connectivity is by node indices alone.
struct FlatMesh {
  std::span<const Point2> positions;    ///< #N
  std::span<const Triangle> triangles;  ///< #F, positive area cross(b - a, c - a) / 2
};

/// The corners at each node, ascending: those of node n are entries begin[n] .. begin[n + 1] - 1.
struct NodeCorners {
  std::vector<int> begin;      ///< #N + 1
  std::vector<Corner> corner;  ///< 3 #F

  std::span<const Corner> at(int node) const {
    return {corner.data() + begin[node], corner.data() + begin[node + 1]};
  }
};

/// Lists the corners at each of `nodes` nodes. O(N + F).
NodeCorners corners_at_nodes(std::span<const Triangle> triangles, size_t nodes);

/// Computes the area of each triangle, #F. O(F).
std::vector<double> triangle_areas(const FlatMesh& mesh);

/// Computes the connected component of each node, #nodes, named by its smallest node. Near-linear.
std::vector<int> connected_pieces(std::span<const Triangle> triangles, size_t nodes);

}  // namespace relievo

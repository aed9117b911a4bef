#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/geometry/point.h"

namespace relievo {

/// What a node of the joined mesh is; decides its boundary condition in the inflation.
enum class NodeRole : uint8_t {
  interior,  ///< inside a surface
  outline,   ///< on an outline: u = 0
  seam,      ///< on a join, its merged ends included: an ordinary interior node
  flap,      ///< on the free edge of a covered lip: natural boundary
  ramp,      ///< on an outline under a Robin range
};

/// One Robin range as it lies on the mesh.
struct RobinRamp {
  int upper = -1;
  int lower = -1;
  double length = 0;   ///< arc length of the range, px
  double alpha0 = -1;  ///< given by the scene, or < 0: use the default
  double rho = -1;     ///< likewise
};

/// A node under a Robin range (its role is `ramp`).
struct RampNode {
  int node = -1;
  int ramp = -1;
  double t = 0;     ///< arc length from the flexible end / length of the range, in (0, 1)
  double mass = 0;  ///< lumped boundary mass: half the length of the adjacent outline edges, px
};

/// h[lower] <= h[upper], or equal. Both nodes lie at the same base vertex. [P eq 11]
struct DepthPair {
  int lower = -1;
  int upper = -1;
  bool equal = false;
  friend bool operator==(const DepthPair&, const DepthPair&) = default;
};

/// An edge along a crease of a part. Both faces beside it share its nodes.
struct CreaseEdge {
  int cue = -1;                       ///< of the scene
  std::array<int, 2> corner{-1, -1};  ///< opposite to it in both faces, as 3 * face + k
};

/// All parts on one planar triangulation. A *face* is one part's copy of a base triangle; the
/// faces of a base triangle are consecutive, back to front. A *node* is a vertex of the joined
/// mesh: one surface's copy of a base vertex. Lengths are in canvas px, y down.
struct LayeredMesh {
  std::vector<Point2> vertices;               ///< #V base vertices
  std::vector<std::array<int, 3>> triangles;  ///< #T, positive signed area in canvas px (y down)
  /// #T x 3, entry k is the triangle across the edge opposite to corner k, or -1.
  std::vector<std::array<int, 3>> neighbours;

  std::vector<int>
      stack_begin;  ///< #T+1: faces of triangle t are [stack_begin[t], stack_begin[t+1])
  std::vector<int> face_triangle;         ///< #F base triangle of each face
  std::vector<int> face_part;             ///< #F part of each face
  std::vector<std::array<int, 3>> faces;  ///< #F nodes, corner k lies at corner k of the triangle

  std::vector<int> node_vertex;     ///< #N base vertex of each node
  std::vector<int> node_part;       ///< #N frontmost part that uses the node
  std::vector<NodeRole> node_role;  ///< #N

  std::vector<RobinRamp> ramps;
  std::vector<RampNode> ramp_nodes;
  std::vector<DepthPair> constraints;
  std::vector<CreaseEdge> creases;

  int part_count = 0;
  double edge_length = 0;             ///< spacing of the outlines, px
  std::vector<std::string> warnings;  ///< what was repaired or left out, for a person
};

}  // namespace relievo

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/geometry/triangles.h"
#include "relievo/point.h"

namespace relievo::relief {

/// What a node of the joined mesh is; decides its boundary condition in the inflation.
enum class NodeRole : uint8_t {
  interior,  ///< inside a surface
  outline,   ///< on an outline: u = 0
  seam,      ///< on a join, its merged ends included: an ordinary interior node
  flap,      ///< on the free edge of a covered lip: natural boundary
  ramp,      ///< on an outline under a Robin range
};

/// Whether a face lies under a part that grows out of its surface, and what that makes of it.
enum class Flap : uint8_t {
  none,   ///< it does not
  loose,  ///< it follows the rest of its sheet and shapes nothing: what is called a flap
  kept,   ///< it shapes the surface as others do, but nothing rests on it
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
  int below = -1;   ///< node of the lower surface there that it is attached to, or -1
  double t = 0;     ///< arc length from the flexible end / length of the range, in (0, 1)
  double mass = 0;  ///< lumped boundary mass: half the length of the adjacent outline edges, px
};

/// A node on the outline of a bump: a joined part whose outline does not leave the lower surface,
/// and whose faces are the lower surface's there.
struct BumpNode {
  int node = -1;
  int part = -1;  ///< of the bump
  int ramp = -1;  ///< under which it lies, or -1
  double t = 1;   ///< as of a ramp node; 0 on the join, 1 where it is neither on it nor on a ramp
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
  int cue = -1;                          ///< of the scene
  std::array<Corner, 2> corner{-1, -1};  ///< opposite to it in both faces
};

/// All parts on one planar triangulation. A *face* is one part's copy of a base triangle; the
/// faces of a base triangle are consecutive, back to front (in the order of parts, but where
/// relations "below" say otherwise). A *node* is a vertex of the joined
/// mesh: one surface's copy of a base vertex. Lengths are in canvas px, y down.
struct LayeredMesh {
  std::vector<Point2> vertices;     ///< #V base vertices
  std::vector<Triangle> triangles;  ///< #T, positive signed area in canvas px (y down)
  /// #T x 3, entry k is the triangle across the edge opposite to corner k, or -1.
  std::vector<std::array<int, 3>> neighbours;

  std::vector<int>
      stack_begin;  ///< #T+1: faces of triangle t are [stack_begin[t], stack_begin[t+1])
  std::vector<int> face_triangle;  ///< #F base triangle of each face
  std::vector<int> face_part;      ///< #F part of each face
  /// #F, the part that inflates each face: another one only where it is a bump on that. Empty where
  /// there is no bump.
  std::vector<int> face_source;
  std::vector<Triangle> faces;  ///< #F nodes, corner k lies at corner k of the triangle
  std::vector<Flap> face_flap;  ///< #F, or empty: all none

  std::vector<int> node_vertex;     ///< #N base vertex of each node
  std::vector<int> node_part;       ///< #N frontmost part that uses the node
  std::vector<NodeRole> node_role;  ///< #N

  std::vector<RobinRamp> ramps;
  std::vector<RampNode> ramp_nodes;
  std::vector<BumpNode> bump_nodes;  ///< by part
  /// Between nodes that are seen from the front, and where a part that is seen may rest on what
  /// lies directly below it.
  std::vector<DepthPair> constraints;
  std::vector<CreaseEdge> creases;

  int part_count = 0;
  double edge_length = 0;             ///< spacing of the outlines, px
  std::vector<std::string> warnings;  ///< what was repaired or left out, for a person

  /// The part whose c, d, flat and lean hold on a face.
  int source(size_t face) const {
    return face_source.empty() ? face_part[face] : face_source[face];
  }
  bool is_flap(size_t face) const { return flap(face) == Flap::loose; }
  Flap flap(size_t face) const { return face_flap.empty() ? Flap::none : face_flap[face]; }
};

/// Whether a node with this role lies within a surface, joins included.
inline bool is_inside(NodeRole role) {
  return role == NodeRole::interior || role == NodeRole::seam;
}

/// Scene units per px: multiplied by it, the box around all faces has a diagonal of 2. This gives
/// the Robin coefficient and epsilon, which have units of length, the same meaning at any size.
/// 1 where there is no face. O(F).
double scene_scale(const LayeredMesh& mesh);

/// Where each node lies, canvas px times `scale`, #N. With the faces it is the flat joined mesh.
std::vector<Point2> node_positions(const LayeredMesh& mesh, double scale = 1);

/// Whether each node is at a face that is in front of all others, #N. O(T + N).
std::vector<uint8_t> seen_nodes(const LayeredMesh& mesh);

/// The face that shares both nodes of the edge opposite to corner k, in whatever part, or -1 where
/// the joined surface ends. O(height of the stack).
int face_across(const LayeredMesh& mesh, int face, int k);

/// The faces of each part, ascending, but for flaps. O(F).
std::vector<std::vector<int>> faces_by_part(const LayeredMesh& mesh);

/// The faces that shape the surface: all but flaps. O(F).
std::vector<std::array<int, 3>> shaping_faces(const LayeredMesh& mesh);

/// The joined surface of each node, #N, named by its smallest node. Near-linear.
std::vector<int> joined_surfaces(const LayeredMesh& mesh);

}  // namespace relievo::relief

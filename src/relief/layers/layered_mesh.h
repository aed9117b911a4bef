#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "kernel/geometry/triangles.h"
#include "relievo/point.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The role of a node of the joined mesh. It decides the boundary condition in the inflation.
enum class NodeRole : uint8_t {
  interior,  ///< inside a surface
  outline,   ///< on an outline: u = 0
  seam,      ///< on a join, its merged ends included: an ordinary interior node
  flap,      ///< on the free edge of a flap: natural boundary
  ramp,      ///< on an outline within a Robin range
};

/// How a face takes part in the inflation, depending on what lies in front of it.
enum class Flap : uint8_t {
  none,   ///< no part that grows out of its surface lies in front of it
  loose,  ///< such a part does: the face is a flap, follows its sheet and shapes nothing
  kept,   ///< such a part does, but the face shapes the surface; nothing rests on it
};

/// A Robin range on the mesh. With t as in RampNode, [P eq 9] holds in the form
///   alpha u + (1 - alpha) l du/dn = 0,  alpha = alpha0 + (1 - alpha0) t,  l = rho * length.
struct RobinRamp {
  int upper = -1;
  int lower = -1;
  double length = 0;   ///< arc length of the range, px
  double alpha0 = -1;  ///< in [0, 1]; negative where the scene leaves the default
  double rho = -1;     ///< positive; negative where the scene leaves the default
};

/// A node within a Robin range. Its role is `ramp`.
struct RampNode {
  int node = -1;
  int ramp = -1;
  int below = -1;   ///< node of the lower surface at the same vertex that it is attached to, or -1
  double t = 0;     ///< arc length from the start of the range / length of the range, in (0, 1)
  double mass = 0;  ///< lumped boundary mass: half the length of the adjacent outline edges, px
};

/// A node on the outline of a bump. A bump is a joined part whose outline does not leave the lower
/// surface; its faces replace those of the lower surface there.
struct BumpNode {
  int node = -1;
  int part = -1;  ///< the bump
  int ramp = -1;  ///< the Robin range that the node lies in, or -1
  double t = 1;   ///< as in RampNode; 0 on the join, 1 outside joins and ranges
};

/// h[lower] <= h[upper], or h[lower] = h[upper]. Both nodes lie at the same base vertex. [P eq 11]
struct DepthPair {
  int lower = -1;
  int upper = -1;
  bool equal = false;
  friend bool operator==(const DepthPair&, const DepthPair&) = default;
};

/// An edge along a crease of a part. The faces on both sides share its nodes.
struct CreaseEdge {
  int cue = -1;                          ///< of the scene
  std::array<Corner, 2> corner{-1, -1};  ///< the corner opposite to the edge in each of the faces
};

/// All parts on one planar triangulation. A *face* is one part's copy of a base triangle. The
/// faces of a base triangle are its *stack*: they are consecutive, back to front, in the order of
/// the parts unless relations "below" change it. A *node* is a vertex of the joined mesh: one
/// surface's copy of a base vertex. Lengths are in canvas px, y down.
struct LayeredMesh {
  std::vector<Point2> vertices;     ///< #V base vertices
  std::vector<Triangle> triangles;  ///< #T, positive signed area in canvas px (y down)
  /// #T x 3, entry k is the triangle across the edge opposite to corner k, or -1.
  std::vector<std::array<int, 3>> neighbours;

  /// #T+1: the faces of triangle t are [stack_begin[t], stack_begin[t+1]).
  std::vector<int> stack_begin;
  std::vector<int> face_triangle;  ///< #F base triangle of each face
  std::vector<int> face_part;      ///< #F part of each face
  /// #F, the part whose c and d inflate each face: its own, or for a face of a bump the part that
  /// the bump lies on. Empty where the scene has no bump.
  std::vector<int> face_source;
  std::vector<Triangle> faces;  ///< #F nodes, corner k lies at corner k of the triangle
  std::vector<Flap> face_flap;  ///< #F, or empty: all none

  std::vector<int> node_vertex;     ///< #N base vertex of each node
  std::vector<int> node_part;       ///< #N frontmost part that uses the node
  std::vector<NodeRole> node_role;  ///< #N

  std::vector<RobinRamp> ramps;
  std::vector<RampNode> ramp_nodes;
  std::vector<BumpNode> bump_nodes;  ///< by part
  /// The sets C of [P eq 11], between nodes that are visible from the front, and pairs at which a
  /// visible part may rest on the face directly below it.
  std::vector<DepthPair> constraints;
  std::vector<CreaseEdge> creases;

  int part_count = 0;
  double edge_length = 0;             ///< spacing of the outlines, px
  std::vector<std::string> warnings;  ///< sentences for people about repairs and omissions

  /// The part whose c, d, flat and lean apply to a face.
  int source(size_t face) const {
    return face_source.empty() ? face_part[face] : face_source[face];
  }
  bool is_flap(size_t face) const { return flap(face) == Flap::loose; }
  Flap flap(size_t face) const { return face_flap.empty() ? Flap::none : face_flap[face]; }
};

/// Returns whether a node with this role lies within a surface, joins included.
inline bool is_inside(NodeRole role) {
  return role == NodeRole::interior || role == NodeRole::seam;
}

/// Returns the scene units per px, 2 / (diagonal of the box around all faces), or 1 if there is no
/// face. Solving in scene units gives quantities with units of length, such as the Robin
/// coefficient and epsilon, the same meaning at any size. O(F).
double scene_scale(const LayeredMesh& mesh);

/// Returns the position of each node in canvas px times `scale`, #N. With the faces these make the
/// flat joined mesh.
std::vector<Point2> node_positions(const LayeredMesh& mesh, double scale = 1);

/// Flags the nodes of the frontmost face of each stack, #N. O(T + N).
std::vector<uint8_t> seen_nodes(const LayeredMesh& mesh);

/// Returns the face that shares both nodes of the edge opposite to corner k, whichever part it
/// belongs to, or -1 where the joined surface ends. O(height of the stack).
int face_across(const LayeredMesh& mesh, int face, int k);

/// Lists the faces of each part in ascending order, without flaps. O(F).
std::vector<std::vector<int>> faces_by_part(const LayeredMesh& mesh);

/// Lists the faces that shape the surface: all but flaps. O(F).
std::vector<std::array<int, 3>> shaping_faces(const LayeredMesh& mesh);

/// Returns the pairs of parts that a relation "free" without a range lets cross, the later part
/// first, sorted.
std::vector<std::pair<int, int>> free_parts(const Scene& scene);

/// Checks whether two faces may cross. `free`: free_parts of the scene.
bool may_cross(const LayeredMesh& mesh, const std::vector<std::pair<int, int>>& free, int face,
               int other);

/// Numbers the joined surface of each node, #N, by its smallest node. Near-linear.
std::vector<int> joined_surfaces(const LayeredMesh& mesh);

}  // namespace relievo::relief

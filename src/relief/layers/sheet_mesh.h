#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/geometry/triangles.h"
#include "kernel/meshing/triangulate.h"
#include "relief/layers/cover.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A vertex where a join goes over from a sheet to that of a part in front of it, or back.
struct Mount {
  int vertex = -1;
  int part = -1;  ///< the one in front, whose outline it lies on
};

/// A join as it was made.
struct Seam {
  int upper = -1;
  int lower = -1;
  int loop = -1;                  ///< of the upper part, that it runs along
  int position = 0;               ///< of its first vertex in the loop
  int edges = 0;                  ///< it has edges + 1 vertices, ends included
  bool first_end_inside = false;  ///< the end was merged into the inside of the lower surface
  bool last_end_inside = false;
  bool bump = false;         ///< the upper part lies on the lower surface with all of its outline
  std::vector<int> covered;  ///< faces of the lower surface beside it, under the upper part
  std::vector<Mount> mounts;
};

/// The outlines as loops of base vertices.
struct Loops {
  std::vector<std::vector<int>> vertices;
  std::vector<int> part;  ///< per loop

  /// Positions beyond the ends go round.
  int vertex(int loop, int position) const;
};

/// A base triangulation, the sheets of all parts over it, and how these are joined. Faces and nodes
/// are as in LayeredMesh, but uncovered triangles are there, with empty stacks, and faces of a
/// stack lie in the order of parts.
struct SheetMesh {
  std::vector<Point2> points;
  PlanarTriangulation base;
  NodeCorners base_corners;  ///< at each vertex, of triangles
  Loops loops;

  std::vector<int> stack_begin;    ///< #T+1
  std::vector<int> face_part;      ///< #F
  std::vector<int> face_source;    ///< #F part that inflates it
  std::vector<int> face_triangle;  ///< #F
  std::vector<Triangle> faces;     ///< #F nodes
  std::vector<int> node_vertex;    ///< #N
  std::vector<int> node_part;      ///< #N

  std::vector<Seam> seams;   ///< one per join
  std::vector<int> surface;  ///< per part: the lowest part it is joined with, itself if none

  /// The triangle with the directed edge a -> b (it lies on its positive side), or -1.
  int triangle_left_of(int a, int b) const;

  /// The face of `part` over triangle t, or -1. t may be -1.
  int face_of(int t, int part) const;

  /// The face that shares both nodes of the edge opposite to corner k, or -1 at an open edge.
  int face_across(int face, int k) const;

  /// The node of a face at a base vertex of its triangle.
  int node_at(int face, int vertex) const {
    return faces[face][place_of_node(base.triangles[face_triangle[face]], vertex)];
  }

  /// The node of `part` at `vertex` beside the loop edge ab, or -1 where that edge is not on the
  /// part's outline.
  int outline_node(int part, int a, int b, int vertex) const;

  /// Length of the edge of a loop from a position to the next one, or, with direction -1, to the
  /// one before.
  double loop_step(int loop, int position, int direction) const {
    return distance(points[loops.vertex(loop, position)],
                    points[loops.vertex(loop, position + direction)]);
  }
};

/// One sheet per part, not yet joined: a node per covered vertex and part. O(T + F).
SheetMesh make_sheets(std::vector<Point2> points, PlanarTriangulation base, Loops loops,
                      const Cover& cover);

/// Takes the flagged faces (#F) out of the stacks; the new number of each face, -1 where it is
/// gone. O(F).
std::vector<int> drop_faces(const std::vector<uint8_t>& dropped, SheetMesh& mesh);

/// Whether no other face lies on the same side of any edge of the face, and at most one across it.
bool has_plain_edges(const SheetMesh& mesh, int face);

/// Splits nodes whose faces form more than one fan, so that the mesh is manifold. Returns the pairs
/// of copies, which belong at the same height. O(F).
std::vector<DepthPair> split_fans(SheetMesh& mesh);

/// The frontmost part that uses each node, -1 where none does. O(F).
std::vector<int> frontmost_parts(const SheetMesh& mesh);

/// Whether all parts of the surface of a part are raised, or all sunk. Other surfaces pass height 0
/// in their midst; they are not attached beside joins and have no flaps. O(parts).
bool has_one_sign(const SheetMesh& mesh, const Scene& scene, int part);

}  // namespace relievo::relief

#pragma once

#include <cstdint>
#include <vector>

#include "kernel/geometry/triangles.h"
#include "kernel/meshing/triangulate.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A run of base vertices along one loop.
struct LoopRun {
  int loop = -1;          ///< -1: the run has collapsed
  int position = 0;       ///< of its first vertex in the loop
  int edges = 0;          ///< the run has edges + 1 vertices
  bool reversed = false;  ///< the user's first point is its last vertex
};

/// A join on the mesh.
struct Seam {
  int upper = -1;
  int lower = -1;
  LoopRun run;                    ///< along a loop of the upper part
  bool first_end_inside = false;  ///< the first vertex was merged into the inside of the lower part
  bool last_end_inside = false;
  bool bump = false;         ///< the whole outline of the upper part lies on the lower surface
  std::vector<int> covered;  ///< faces of the lower surface beside it, behind the upper part
};

/// A base triangulation, the sheets of all parts over it, and their joins. Faces, stacks and nodes
/// are those of LayeredMesh, except that uncovered triangles are present, with empty stacks, and
/// that every stack is in the order of parts.
struct SheetMesh {
  std::vector<Point2> points;
  PlanarTriangulation base;
  NodeCorners base_corners;             ///< corners of triangles at each point
  std::vector<std::vector<int>> loops;  ///< the outlines, as points around each ring
  std::vector<int> loop_part;           ///< per loop

  std::vector<int> stack_begin;    ///< #T+1
  std::vector<int> face_part;      ///< #F
  std::vector<int> face_source;    ///< #F part that inflates it
  std::vector<int> face_triangle;  ///< #F
  std::vector<Triangle> faces;     ///< #F nodes
  std::vector<int> node_vertex;    ///< #N

  std::vector<Seam> seams;   ///< one per join
  std::vector<int> surface;  ///< per part: the lowest part that it is joined with, itself if none
  /// Per part: points of its outline at which a join passes from its sheet to one behind it.
  std::vector<std::vector<int>> passed;

  /// The point at a position of a loop; positions are taken modulo its size.
  int loop_vertex(int loop, int position) const;

  /// The triangle with the directed edge a -> b, which lies on its positive side, or -1.
  int triangle_left_of(int a, int b) const;

  /// The face of `part` over triangle t, or -1. t may be -1.
  int face_of(int t, int part) const;

  /// The face that shares both nodes of the edge opposite to corner k, or -1 at an open edge.
  int face_across(int face, int k) const;

  /// The node of a face at a point of its triangle.
  int node_at(int face, int vertex) const {
    return faces[face][place_of_node(base.triangles[face_triangle[face]], vertex)];
  }

  /// The node of `part` at `vertex`, one of the ends of the loop edge ab, or -1 if that edge is not
  /// on the part's outline.
  int outline_node(int part, int a, int b, int vertex) const;

  /// Length of the edge of a loop from a position to the next one, or to the one before if
  /// `direction` is -1.
  double loop_step(int loop, int position, int direction) const {
    return distance(points[loop_vertex(loop, position)],
                    points[loop_vertex(loop, position + direction)]);
  }

  /// Length of a run, px.
  double run_length(const LoopRun& run) const;

  /// The points of a run, in the direction of its loop.
  std::vector<int> run_vertices(const LoopRun& run) const;
};

/// Makes one node per covered point and part, so that no sheet is joined to another yet.
/// Precondition: points, base and stacks are filled. O(T + F log F).
void make_nodes(SheetMesh& mesh);

/// Removes the flagged faces (#F) from the stacks. Returns the new number of each face, or -1 for
/// removed ones. O(T + F).
std::vector<int> drop_faces(const std::vector<uint8_t>& dropped, SheetMesh& mesh);

/// Splits nodes whose faces form more than one fan, which makes the mesh manifold. Returns the
/// pairs of copies, tied by equalities. O(F).
std::vector<DepthPair> split_fans(SheetMesh& mesh);

/// Returns whether all parts joined to a part, itself included, have d of one sign. The height of
/// other surfaces passes through 0 in their inside, so these are not attached beside joins and have
/// no flaps. O(parts).
bool has_one_sign(const SheetMesh& mesh, const Scene& scene, int part);

/// Fills the stacks and the arrays of faces of `mesh` (nodes not yet) from its loops and their
/// parts. A part covers a triangle if the winding number of its loops there is not 0; winding
/// numbers are found by a flood fill, in which every crossed edge adds the loops that run along it.
/// Precondition: the loops' edges are edges of the base. O(T log(edges) + F).
void cover_triangles(SheetMesh& mesh);

/// Removes the connected pieces of each part that have less than `least_area`, px^2.
/// Precondition: the sheets are not joined yet. O(T + F).
void drop_specks(double least_area, SheetMesh& mesh);

}  // namespace relievo::relief

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/meshing/triangulate.h"
#include "relief/layers/cover.h"
#include "relief/layers/layered_mesh.h"

namespace relievo {

/// A corner of a base triangle or of a face: 3 * index + k.
using Corner = int;

/// Base triangulation with look-ups. Uncovered triangles have empty stacks.
struct BaseMesh {
  std::vector<Point2> points;
  PlanarTriangulation mesh;
  std::vector<int> corner_begin;  ///< #V+1
  std::vector<Corner> corners;    ///< triangle corners at each vertex

  /// The triangle with the directed edge a -> b (it lies on its positive side), or -1.
  int triangle_left_of(int a, int b) const;
};

/// Adds the look-ups. O(T).
BaseMesh make_base_mesh(std::vector<Point2> points, PlanarTriangulation mesh);

/// The faces and nodes of all sheets while they are being joined.
struct Sheets {
  std::vector<int> stack_begin;           ///< #T+1
  std::vector<int> face_part;             ///< #F
  std::vector<int> face_source;           ///< #F part that inflates it
  std::vector<int> face_triangle;         ///< #F
  std::vector<std::array<int, 3>> faces;  ///< #F nodes
  std::vector<int> node_vertex;           ///< #N
  std::vector<int> node_part;             ///< #N

  /// The face of `part` over triangle t, or -1. t may be -1.
  int face_of(int t, int part) const;
};

/// One sheet per part, not yet joined: a node per covered vertex and part. O(F).
Sheets make_sheets(const BaseMesh& base, const Cover& cover);

/// Takes the flagged faces (#F) out of the stacks; the new number of each face, -1 where it is
/// gone. O(F).
std::vector<int> drop_faces(const std::vector<uint8_t>& dropped, Sheets& sheets);

/// The face that shares both nodes of the edge opposite to corner k, or -1 at an open edge.
int face_across(const BaseMesh& base, const Sheets& sheets, int face, int k);

/// Whether no other face lies on the same side of any edge of the face, and at most one across it.
bool has_plain_edges(const BaseMesh& base, const Sheets& sheets, int face);

/// Splits nodes whose faces form more than one fan, so that the mesh is manifold. Returns the
/// pairs of copies, which belong at the same height. O(F).
std::vector<DepthPair> split_fans(const BaseMesh& base, Sheets& sheets);

}  // namespace relievo

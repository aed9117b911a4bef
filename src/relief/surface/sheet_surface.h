#pragma once

#include <array>
#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relievo/model.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The copy of one base edge on a face: the edge opposite to its corner.
struct FaceEdge {
  int face = -1;
  int corner = -1;

  Corner index() const { return corner_of(face, corner); }
};

/// The two faces beside one base edge between which the surface is open, to be closed by a wall.
using OpenEdge = std::array<FaceEdge, 2>;

/// The faces that a model keeps and their connections. Corners and edges are numbered as in
/// corner_of; entries of faces that are not kept are -1.
struct SheetSurface {
  std::vector<int> kept_begin;   ///< #T faces [kept_begin[t], stack_begin[t + 1]) are kept, except
                                 ///< those left out
  std::vector<int> across;       ///< #F x 3 kept face that shares both nodes of the edge, or -1
  std::vector<int> edge;         ///< #F x 3 index of the edge opposite to the corner
  std::vector<int> vertex;       ///< #F x 3 vertex at the corner: one for every fan of faces,
                                 ///< which ends at creases
  std::vector<int> vertex_node;  ///< #V node at the vertex
  std::vector<FaceEdge> vertex_corner;  ///< #V one of the corners at the vertex
  std::vector<FaceEdge> edge_owner;     ///< #E the first face at the edge; the edge runs from
                                        ///< its corner + 1 to its corner + 2
  std::vector<FaceEdge> edge_twin;      ///< #E the other face at a crease
  std::vector<OpenEdge> open_edges;     ///< to be closed by walls, by base triangle
};

/// Chooses the faces, connects those that share nodes and lists the open edges that need walls:
/// all inner ones for `relief`, and for `orbit` those that a part with d < 0 cuts into the surface
/// below it. `left_out`: faces that no model keeps, ascending; none is in front.
/// O(faces * height of a stack).
SheetSurface connect_faces(const LayeredMesh& mesh, const Scene& scene,
                           const std::vector<int>& left_out, Visibility visibility);

}  // namespace relievo::relief

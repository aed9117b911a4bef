#include "relief/surface/sheet_surface.h"

#include <algorithm>
#include <utility>

#include "kernel/base/disjoint_sets.h"

namespace relievo::relief {
namespace {

int first_kept_face(const LayeredMesh& mesh, const Scene& scene, Visibility visibility, int t) {
  const int begin = mesh.stack_begin[t];
  const int end = mesh.stack_begin[t + 1];
  if (visibility == Visibility::all || begin == end) return begin;
  if (visibility == Visibility::relief) return end - 1;
  for (int f = end - 1; f > begin; --f)
    if (scene.parts[mesh.face_part[f]].d < 0) return f;
  return begin;
}

/// Returns the last face of [begin, end) that shares the nodes of `edge`, or -1.
int face_across(const LayeredMesh& mesh, FaceEdge edge, int begin, int end) {
  if (begin == end) return -1;
  const int t = mesh.face_triangle[begin];
  const int corner = place_of_node(mesh.neighbours[t], mesh.face_triangle[edge.face]);
  for (int f = end - 1; f >= begin; --f)
    if (share_edge(mesh.faces[edge.face], edge.corner, mesh.faces[f], corner)) return f;
  return -1;
}

class Connector {
 public:
  Connector(const LayeredMesh& mesh, const Scene& scene, const std::vector<int>& left_out,
            Visibility visibility)
      : mesh_(mesh), left_out_(left_out), fans_(static_cast<int>(3 * mesh.faces.size())) {
    const int triangles = static_cast<int>(mesh.triangles.size());
    surface_.kept_begin.resize(triangles);
    for (int t = 0; t < triangles; ++t)
      surface_.kept_begin[t] = first_kept_face(mesh, scene, visibility, t);
    const size_t corners = 3 * mesh.faces.size();
    surface_.across.assign(corners, -1);
    surface_.edge.assign(corners, -1);
    surface_.vertex.assign(corners, -1);
    for (const CreaseEdge& edge : mesh.creases)
      creased_.insert(creased_.end(), edge.corner.begin(), edge.corner.end());
    std::sort(creased_.begin(), creased_.end());
  }

  SheetSurface connect(Visibility visibility) {
    for_each_kept_edge([this](FaceEdge edge, int t) { pair_edge(edge, t); });
    number_vertices();
    if (visibility == Visibility::relief)
      for_each_kept_edge([this](FaceEdge edge, int t) { find_step(edge, t); });
    if (visibility == Visibility::orbit)
      for_each_kept_edge([this](FaceEdge edge, int t) { find_cut(edge, t); });
    return std::move(surface_);
  }

 private:
  template <class Visit>
  void for_each_kept_edge(Visit visit) {
    for (size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (int f = surface_.kept_begin[t]; f < mesh_.stack_begin[t + 1]; ++f)
        if (is_kept(f))
          for (int k = 0; k < 3; ++k) visit({f, k}, mesh_.neighbours[t][k]);
  }

  bool is_kept(int face) const {
    return !std::binary_search(left_out_.begin(), left_out_.end(), face);
  }

  void pair_edge(FaceEdge edge, int other_triangle) {
    const int slot = edge.index();
    if (surface_.edge[slot] >= 0) return;
    surface_.edge[slot] = static_cast<int>(surface_.edge_owner.size());
    surface_.edge_owner.push_back(edge);
    surface_.edge_twin.emplace_back();
    if (other_triangle < 0) return;
    const int other = face_across(mesh_, edge, surface_.kept_begin[other_triangle],
                                  mesh_.stack_begin[other_triangle + 1]);
    if (other < 0 || !is_kept(other)) return;
    const int k = place_of_node(mesh_.neighbours[other_triangle], mesh_.face_triangle[edge.face]);
    if (surface_.edge[corner_of(other, k)] >= 0) return;
    surface_.edge[corner_of(other, k)] = surface_.edge[slot];
    surface_.across[slot] = other;
    surface_.across[corner_of(other, k)] = edge.face;
    if (std::binary_search(creased_.begin(), creased_.end(), slot)) {
      surface_.edge_twin.back() = {other, k};
      return;
    }
    for (const int side : {1, 2})
      fans_.unite(corner_of(edge.face, (edge.corner + side) % 3),
                  corner_of(other, (k + 3 - side) % 3));
  }

  void number_vertices() {
    for_each_kept_edge([this](FaceEdge corner, int) {
      const int slot = corner.index();
      const int first = fans_.find(slot);
      if (first == slot) {
        surface_.vertex[slot] = static_cast<int>(surface_.vertex_node.size());
        surface_.vertex_node.push_back(mesh_.faces[corner.face][corner.corner]);
        surface_.vertex_corner.push_back(corner);
      }
      surface_.vertex[slot] = surface_.vertex[first];
    });
  }

  void find_step(FaceEdge edge, int other_triangle) {
    const int triangle = mesh_.face_triangle[edge.face];
    if (other_triangle < triangle || surface_.across[edge.index()] >= 0) return;
    const int other = mesh_.stack_begin[other_triangle + 1] - 1;
    if (other < mesh_.stack_begin[other_triangle]) return;
    surface_.open_edges.push_back(
        {edge, FaceEdge{other, place_of_node(mesh_.neighbours[other_triangle], triangle)}});
  }

  /// Pairs the lowest kept face of a triangle with the uppermost surface that is cut along its
  /// edge.
  void find_cut(FaceEdge edge, int other_triangle) {
    const int triangle = mesh_.face_triangle[edge.face];
    const int dropped = mesh_.stack_begin[triangle];
    if (other_triangle < 0 || edge.face != surface_.kept_begin[triangle] || edge.face == dropped)
      return;
    if (surface_.across[edge.index()] >= 0) return;
    const int k = place_of_node(mesh_.neighbours[other_triangle], triangle);
    for (int f = mesh_.stack_begin[other_triangle + 1] - 1;
         f >= surface_.kept_begin[other_triangle]; --f) {
      if (!is_kept(f) || face_across(mesh_, {f, k}, dropped, edge.face) < 0) continue;
      surface_.open_edges.push_back({edge, FaceEdge{f, k}});
      return;
    }
  }

  const LayeredMesh& mesh_;
  const std::vector<int>& left_out_;
  SheetSurface surface_;
  DisjointSets fans_;         ///< corners around one vertex
  std::vector<int> creased_;  ///< corners opposite to creases, sorted
};

}  // namespace

SheetSurface connect_faces(const LayeredMesh& mesh, const Scene& scene,
                           const std::vector<int>& left_out, Visibility visibility) {
  return Connector(mesh, scene, left_out, visibility).connect(visibility);
}

}  // namespace relievo::relief

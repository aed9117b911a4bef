#include "relief/layers/layered_mesh.h"

#include <algorithm>

#include "kernel/geometry/polygon.h"

namespace relievo::relief {

double scene_scale(const LayeredMesh& mesh) {
  Box2 box;
  for (const int triangle : mesh.face_triangle)
    for (const int vertex : mesh.triangles[triangle]) box.add(mesh.vertices[vertex]);
  const double diagonal = box.diagonal();
  return diagonal > 0 ? 2 / diagonal : 1;
}

std::vector<Point2> node_positions(const LayeredMesh& mesh, double scale) {
  std::vector<Point2> positions;
  positions.reserve(mesh.node_vertex.size());
  for (const int vertex : mesh.node_vertex) positions.push_back(scale * mesh.vertices[vertex]);
  return positions;
}

std::vector<uint8_t> seen_nodes(const LayeredMesh& mesh) {
  std::vector<uint8_t> seen(mesh.node_vertex.size(), 0);
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.stack_begin[t] < mesh.stack_begin[t + 1])
      for (const int n : mesh.faces[mesh.stack_begin[t + 1] - 1]) seen[n] = 1;
  return seen;
}

int face_across(const LayeredMesh& mesh, int face, int k) {
  const int triangle = mesh.face_triangle[face];
  const int other = mesh.neighbours[triangle][k];
  if (other < 0) return -1;
  const int corner = place_of_node(mesh.neighbours[other], triangle);
  for (int f = mesh.stack_begin[other]; f < mesh.stack_begin[other + 1]; ++f)
    if (share_edge(mesh.faces[face], k, mesh.faces[f], corner)) return f;
  return -1;
}

std::vector<std::vector<int>> faces_by_part(const LayeredMesh& mesh) {
  std::vector<std::vector<int>> faces(mesh.part_count);
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    if (!mesh.is_flap(f)) faces[mesh.face_part[f]].push_back(static_cast<int>(f));
  return faces;
}

std::vector<std::array<int, 3>> shaping_faces(const LayeredMesh& mesh) {
  std::vector<std::array<int, 3>> faces;
  faces.reserve(mesh.faces.size());
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    if (!mesh.is_flap(f)) faces.push_back(mesh.faces[f]);
  return faces;
}

std::vector<std::pair<int, int>> free_parts(const Scene& scene) {
  std::vector<std::pair<int, int>> parts;
  for (const Relation& relation : scene.relations)
    if (relation.kind == RelationKind::free && !relation.range)
      parts.push_back({relation.upper, relation.lower});
  std::sort(parts.begin(), parts.end());
  return parts;
}

bool may_cross(const LayeredMesh& mesh, const std::vector<std::pair<int, int>>& free, int face,
               int other) {
  const auto [first, last] = std::minmax(mesh.face_part[face], mesh.face_part[other]);
  return std::binary_search(free.begin(), free.end(), std::pair(last, first));
}

std::vector<int> joined_surfaces(const LayeredMesh& mesh) {
  return connected_pieces(mesh.faces, mesh.node_vertex.size());
}

}  // namespace relievo::relief

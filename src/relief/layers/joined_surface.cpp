#include "relief/layers/joined_surface.h"

#include "kernel/base/disjoint_sets.h"
#include "kernel/geometry/polygon.h"

namespace relievo {

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

std::vector<int> joined_surfaces(const LayeredMesh& mesh) {
  const int nodes = static_cast<int>(mesh.node_vertex.size());
  DisjointSets surfaces(nodes);
  for (const auto& [a, b, c] : mesh.faces) {
    surfaces.unite(a, b);
    surfaces.unite(a, c);
  }
  std::vector<int> surface;
  surface.reserve(mesh.node_vertex.size());
  for (int n = 0; n < nodes; ++n) surface.push_back(surfaces.find(n));
  return surface;
}

}  // namespace relievo

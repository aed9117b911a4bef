#include "kernel/geometry/triangles.h"

#include "kernel/base/disjoint_sets.h"

namespace relievo {

NodeCorners corners_at_nodes(std::span<const Triangle> triangles, size_t nodes) {
  NodeCorners result;
  result.begin.assign(nodes + 1, 0);
  for (const Triangle& triangle : triangles)
    for (const int node : triangle) ++result.begin[node + 1];
  for (size_t n = 0; n < nodes; ++n) result.begin[n + 1] += result.begin[n];
  result.corner.resize(3 * triangles.size());
  std::vector<int> next(result.begin.begin(), result.begin.end() - 1);
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) result.corner[next[triangles[t][k]]++] = corner_of(t, k);
  return result;
}

std::vector<double> triangle_areas(const FlatMesh& mesh) {
  std::vector<double> areas;
  areas.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point2 origin = mesh.positions[a];
    areas.push_back(0.5 * cross(mesh.positions[b] - origin, mesh.positions[c] - origin));
  }
  return areas;
}

std::vector<int> connected_pieces(std::span<const Triangle> triangles, size_t nodes) {
  DisjointSets pieces(static_cast<int>(nodes));
  for (const auto& [a, b, c] : triangles) {
    pieces.unite(a, b);
    pieces.unite(a, c);
  }
  std::vector<int> piece(nodes);
  for (int n = 0; n < pieces.size(); ++n) piece[n] = pieces.find(n);
  return piece;
}

}  // namespace relievo

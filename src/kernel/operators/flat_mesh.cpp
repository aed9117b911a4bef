#include "kernel/operators/flat_mesh.h"

namespace relievo {

NodeCorners corners_at_nodes(const FlatMesh& mesh) {
  NodeCorners result;
  result.begin.assign(mesh.positions.size() + 1, 0);
  for (const auto& triangle : mesh.triangles)
    for (const int node : triangle) ++result.begin[node + 1];
  for (size_t n = 0; n < mesh.positions.size(); ++n) result.begin[n + 1] += result.begin[n];
  result.corner.resize(3 * mesh.triangles.size());
  std::vector<int> next(result.begin.begin(), result.begin.end() - 1);
  for (size_t i = 0; i < result.corner.size(); ++i)
    result.corner[next[mesh.triangles[i / 3][i % 3]]++] = static_cast<int>(i);
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

}  // namespace relievo

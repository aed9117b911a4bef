#include "support/model_defect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace relievo::testing {
namespace {

bool is_finite(Point3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

std::string vertex_defect(const Model& model) {
  const size_t n = model.positions.size();
  if (model.normals.size() != n || model.uvs.size() != n) return "arrays of different lengths";
  for (size_t v = 0; v < n; ++v) {
    if (!is_finite(model.positions[v])) return "a position is not finite";
    if (!is_finite(model.normals[v])) return "a normal is not finite";
    if (!std::isfinite(model.uvs[v].x) || !std::isfinite(model.uvs[v].y))
      return "a texture coordinate is not finite";
    const Point3 normal = model.normals[v];
    if (std::abs(std::hypot(normal.x, normal.y, normal.z) - 1) > 1e-6)
      return "a normal is not of unit length";
  }
  return "";
}

std::string face_defect(const Model& model) {
  std::vector<bool> used(model.positions.size(), false);
  std::vector<std::pair<int, int>> edges;
  for (const std::array<int, 3>& triangle : model.triangles)
    for (int k = 0; k < 3; ++k) {
      const int from = triangle[k];
      const int to = triangle[(k + 1) % 3];
      if (from < 0 || static_cast<size_t>(from) >= used.size()) return "a corner does not exist";
      if (from == to) return "two corners of a face are one";
      used[from] = true;
      edges.emplace_back(from, to);
    }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    return "an edge is run through twice the same way";
  if (std::find(used.begin(), used.end(), false) != used.end()) return "a vertex is not used";
  return "";
}

std::string part_defect(const Model& model) {
  int next = 0;
  for (const ModelPart& part : model.parts) {
    if (part.triangle_count < 0 || part.hidden_count < 0 || part.hidden_count > part.triangle_count)
      return "a part has a wrong count of triangles";
    if (part.triangle_count > 0 && part.first_triangle != next) return "parts are no disjoint runs";
    next += part.triangle_count;
  }
  return next == static_cast<int>(model.triangles.size()) ? "" : "triangles belong to no part";
}

}  // namespace

std::string model_defect(const Model& model) {
  for (const auto check : {vertex_defect, face_defect, part_defect})
    if (std::string defect = check(model); !defect.empty()) return defect;
  return "";
}

}  // namespace relievo::testing

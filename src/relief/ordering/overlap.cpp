#include "relief/ordering/overlap.h"

#include <algorithm>
#include <array>

#include "relief/inflation/inflation.h"

namespace relievo {
namespace {

using Face = std::array<int, 3>;

/// Barycentric coordinates of the samples, in fifths.
constexpr std::array<std::array<int, 3>, 6> sample_fifths = {
    {{3, 1, 1}, {1, 3, 1}, {1, 1, 3}, {2, 2, 1}, {2, 1, 2}, {1, 2, 2}}};

/// Pairs of parts (the later one first) that may cross, sorted.
std::vector<std::pair<int, int>> free_parts(const Scene& scene) {
  std::vector<std::pair<int, int>> parts;
  for (const Relation& relation : scene.relations)
    if (relation.kind == RelationKind::free && !relation.range)
      parts.push_back({relation.upper, relation.lower});
  std::sort(parts.begin(), parts.end());
  return parts;
}

bool share_node(const Face& a, const Face& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

double height_at(const Face& face, const std::array<int, 3>& fifths, const std::vector<double>& u,
                 const std::vector<double>& g) {
  double u_here = 0;
  double g_here = 0;
  for (int k = 0; k < 3; ++k) {
    u_here += 0.2 * fifths[k] * u[face[k]];
    g_here += 0.2 * fifths[k] * g[face[k]];
  }
  return g_here + signed_root(u_here);
}

}  // namespace

std::vector<FacePair> stacked_faces(const LayeredMesh& mesh, const Scene& scene) {
  const std::vector<std::pair<int, int>> crossable = free_parts(scene);
  const auto may_cross = [&](int upper, int lower) {
    return std::binary_search(crossable.begin(), crossable.end(),
                              std::pair(std::max(mesh.face_part[upper], mesh.face_part[lower]),
                                        std::min(mesh.face_part[upper], mesh.face_part[lower])));
  };
  std::vector<FacePair> pairs;
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int upper = mesh.stack_begin[t] + 1; upper < mesh.stack_begin[t + 1]; ++upper) {
      if (scene.parts[mesh.face_part[upper]].d < 0) continue;
      int lower = upper - 1;
      while (lower >= mesh.stack_begin[t] && may_cross(upper, lower)) --lower;
      if (lower >= mesh.stack_begin[t]) pairs.push_back({lower, upper});
    }
  return pairs;
}

OverlapSamples sample_overlap(const LayeredMesh& mesh, const std::vector<FacePair>& pairs,
                              const std::vector<double>& u, const std::vector<double>& g,
                              double tolerance) {
  OverlapSamples result;
  for (const FacePair& pair : pairs) {
    const Face& lower = mesh.faces[pair.lower];
    const Face& upper = mesh.faces[pair.upper];
    if (share_node(lower, upper)) continue;
    for (const auto& fifths : sample_fifths) {
      const double dip = height_at(lower, fifths, u, g) - height_at(upper, fifths, u, g);
      if (!(dip > tolerance)) continue;
      ++result.count;
      result.worst = std::max(result.worst, dip);
    }
  }
  return result;
}

}  // namespace relievo

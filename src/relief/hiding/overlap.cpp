#include "relief/hiding/overlap.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

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
    for (int lower = mesh.stack_begin[t + 1] - 2; lower >= mesh.stack_begin[t]; --lower) {
      int upper = lower + 1;
      while (upper < mesh.stack_begin[t + 1] && may_cross(upper, lower)) ++upper;
      if (upper < mesh.stack_begin[t + 1]) pairs.push_back({lower, upper});
    }
  return pairs;
}

Dip worst_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
              const Ordering& ordering) {
  Dip worst{-std::numeric_limits<double>::infinity(), {}};
  for (const auto& [a, b, c] : sample_fifths) {
    const std::array<int, 3> fifths = {a, b, c};
    const double depth = height_at(mesh.faces[pair.lower], fifths, inflation.u, ordering.g) -
                         height_at(mesh.faces[pair.upper], fifths, inflation.u, ordering.g);
    if (depth > worst.depth) worst = {depth, {0.2 * a, 0.2 * b, 0.2 * c}};
  }
  return worst;
}

}  // namespace relievo

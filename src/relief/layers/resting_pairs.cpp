#include "relief/layers/resting_pairs.h"

#include <algorithm>
#include <tuple>

#include "relief/layers/joined_surface.h"

namespace relievo {
namespace {

bool may_pass(const Scene& scene, int front, int back) {
  const int lower = std::min(front, back);
  const int upper = std::max(front, back);
  return std::any_of(scene.relations.begin(), scene.relations.end(), [&](const Relation& relation) {
    return relation.kind == RelationKind::free && !relation.range && relation.upper == upper &&
           relation.lower == lower;
  });
}

/// The face on which the front one over triangle `t` may rest, or -1.
int support(const LayeredMesh& mesh, const Scene& scene, size_t t) {
  const int front = mesh.stack_begin[t + 1] - 1;
  for (int f = front - 1; f >= mesh.stack_begin[t]; --f)
    if (mesh.flap(f) == Flap::none && !may_pass(scene, mesh.face_part[front], mesh.face_part[f]))
      return f;
  return -1;
}

}  // namespace

std::vector<DepthPair> resting_pairs(const LayeredMesh& mesh, const Scene& scene) {
  std::vector<DepthPair> pairs;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int front = mesh.stack_begin[t + 1] - 1;
    if (front <= mesh.stack_begin[t] || scene.parts[mesh.face_part[front]].d < 0) continue;
    const int below = support(mesh, scene, t);
    if (below < 0) continue;
    for (int k = 0; k < 3; ++k) {
      const DepthPair pair{mesh.faces[below][k], mesh.faces[front][k], false};
      if (pair.lower != pair.upper && is_inside(mesh.node_role[pair.lower]) &&
          is_inside(mesh.node_role[pair.upper]))
        pairs.push_back(pair);
    }
  }
  const auto key = [](const DepthPair& pair) { return std::tie(pair.lower, pair.upper); };
  std::sort(pairs.begin(), pairs.end(),
            [&](const DepthPair& a, const DepthPair& b) { return key(a) < key(b); });
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace relievo

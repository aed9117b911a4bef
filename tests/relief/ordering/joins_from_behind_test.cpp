#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "relief/session/build_relief.h"
#include "relief/surface/assemble_model.h"
#include "support/random_limbs.h"

namespace relievo::relief {
namespace {

using namespace testing;

using Places = std::set<std::array<double, 3>>;

/// One or two limbs that grow out from behind a body.
Scene limbs_behind(uint64_t seed) {
  Scene scene = random_limbs(seed);
  scene.joins.clear();
  std::reverse(scene.parts.begin(), scene.parts.end());
  const int body = static_cast<int>(scene.parts.size()) - 1;
  for (int limb = 0; limb < body; ++limb)
    scene.relations.push_back({body, limb, RelationKind::joined, std::nullopt});
  return scene;
}

Relief relief_of(const Scene& scene) {
  ReliefOptions options;
  options.layers.vertex_budget = 3000;
  auto relief = build_relief(scene, options);
  EXPECT_TRUE(relief) << to_string(relief.error());
  return std::move(*relief);
}

/// Returns the positions of the vertices of a part of the model.
Places places_of(const Model& model, int part) {
  Places places;
  const ModelPart& run = model.parts[part];
  for (int t = run.first_triangle; t < run.first_triangle + run.triangle_count; ++t)
    for (const auto vertex : model.triangles[t]) {
      const Point3 p = model.positions[vertex];
      places.insert({p.x, p.y, p.z});
    }
  return places;
}

/// Returns the nodes at each base vertex.
std::vector<std::vector<int>> nodes_at_vertices(const LayeredMesh& mesh) {
  std::vector<std::vector<int>> nodes(mesh.vertices.size());
  for (size_t n = 0; n < mesh.node_vertex.size(); ++n)
    nodes[mesh.node_vertex[n]].push_back(static_cast<int>(n));
  return nodes;
}

TEST(JoinsFromBehind, ShareAllVerticesOfTheOutlineInFront) {
  int shared = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = limbs_behind(seed);
    const Relief relief = relief_of(scene);
    const LayeredMesh& mesh = relief.layers;
    const auto model = assemble_model({mesh, relief.inflation, relief.ordering, scene}, {});
    ASSERT_TRUE(model);
    const int body = mesh.part_count - 1;
    std::vector<Places> places;
    for (int part = 0; part <= body; ++part) places.push_back(places_of(*model, part));
    for (const std::vector<int>& nodes : nodes_at_vertices(mesh)) {
      if (nodes.size() != 2) continue;
      const auto [limb, rim] = std::minmax(
          nodes[0], nodes[1], [&](int a, int b) { return mesh.node_part[a] < mesh.node_part[b]; });
      if (mesh.node_part[rim] != body || mesh.node_role[rim] != NodeRole::outline ||
          !is_inside(mesh.node_role[limb]))
        continue;
      EXPECT_EQ(relief.ordering.h[limb], relief.ordering.h[rim]);
      const Point2 at = mesh.vertices[mesh.node_vertex[rim]];
      const std::array<double, 3> place{at.x, scene.height - at.y, relief.ordering.h[rim]};
      EXPECT_EQ(places[body].count(place), 1U);
      EXPECT_EQ(places[mesh.node_part[limb]].count(place), 1U);
      ++shared;
    }
  }
  EXPECT_GT(shared, 400);
}

}  // namespace
}  // namespace relievo::relief

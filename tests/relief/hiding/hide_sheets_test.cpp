#include "relief/hiding/hide_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflate.h"
#include "relief/layers/layer_parts.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/order_depth.h"
#include "support/random_limbs.h"
#include "support/random_scene.h"
#include "support/solve_once.h"
#include "support/stacked_parts.h"

namespace relievo::relief {
namespace {

using testing::in_box;
using testing::in_disc;

/// A surface before and after its hidden sheets are hidden.
struct Hidden {
  LayeredMesh mesh;
  Scene scene;
  Discretisation discretisation;
  Inflation visible_inflation;
  Ordering visible_ordering;
  Inflation inflation;
  Ordering ordering;
};

Hidden hide(LayeredMesh mesh, const Scene& scene) {
  Hidden result{std::move(mesh), scene, {}, {}, {}, {}, {}};
  result.discretisation = discretise(result.mesh);
  result.visible_inflation = result.inflation = *inflate(result.mesh, scene, {});
  result.visible_ordering = result.ordering =
      *order_depth(result.mesh, result.inflation, scene, {});
  std::optional<FlapSystem> flaps;
  hide_sheets({result.mesh, result.discretisation, result.scene}, flaps, result.inflation,
              result.ordering);
  return result;
}

/// Returns the largest distance, px, by which a face with a node that can be lowered comes out in
/// front of the visible surface.
double worst_dip_of(const Hidden& hidden) {
  double worst = -1e300;
  const std::vector<uint8_t> seen = seen_nodes(hidden.mesh);
  for (FacePair pair : stacked_faces(hidden.mesh, hidden.scene)) {
    pair.upper = hidden.mesh.stack_begin[hidden.mesh.face_triangle[pair.lower] + 1] - 1;
    const std::array<int, 3>& nodes = hidden.mesh.faces[pair.lower];
    if (std::all_of(nodes.begin(), nodes.end(), [&](int n) { return seen[n] != 0; })) continue;
    worst = std::max(worst, worst_dip(hidden.mesh, pair, hidden.inflation, hidden.ordering).depth);
  }
  return worst;
}

void expect_seen_unchanged(const Hidden& hidden) {
  const std::vector<uint8_t> seen = seen_nodes(hidden.mesh);
  for (size_t n = 0; n < seen.size(); ++n) {
    if (seen[n] == 0) continue;
    EXPECT_EQ(hidden.ordering.h[n], hidden.visible_ordering.h[n]);
    EXPECT_EQ(hidden.ordering.grad_g[n], hidden.visible_ordering.grad_g[n]);
    EXPECT_EQ(hidden.inflation.u[n], hidden.visible_inflation.u[n]);
  }
}

Hidden shields_over_ball(int shields) {
  std::vector<testing::Cover> covers = {in_disc({200, 200}, 110)};
  for (int i = 0; i < shields; ++i) covers.push_back(in_box({40, 40}, {360, 360}));
  LayeredMesh mesh = stack_parts(testing::grid_mesh(40, 40, 10), covers);
  Scene scene = testing::scene_of(mesh);
  for (int p = 1; p < mesh.part_count; ++p) scene.parts[p].c = 0.05 - 0.002 * p;
  return hide(std::move(mesh), scene);
}

TEST(HideSheets, LowersABallUnderAFlatShield) {
  const Hidden hidden = shields_over_ball(1);
  EXPECT_GT(hidden.visible_ordering.h[0], -1);
  EXPECT_LE(worst_dip_of(hidden), 0);
  EXPECT_EQ(hidden.ordering.overlap_samples, 0);
  expect_seen_unchanged(hidden);
}

TEST(HideSheets, LowersPilesOfSheets) {
  const Hidden hidden = shields_over_ball(4);
  EXPECT_LE(worst_dip_of(hidden), 0);
  expect_seen_unchanged(hidden);
}

TEST(HideSheets, LetsFreePartsCross) {
  LayeredMesh mesh = stack_parts(testing::grid_mesh(40, 40, 10),
                                 {in_disc({200, 200}, 110), in_box({40, 40}, {360, 360})});
  Scene scene = testing::scene_of(mesh);
  scene.parts[1].c = 0.05;
  scene.relations.push_back({1, 0, RelationKind::free, {}});
  const Hidden hidden = hide(std::move(mesh), scene);
  EXPECT_EQ(hidden.ordering.h, hidden.visible_ordering.h);
}

TEST(HideSheets, HangsFlapsUpWhereTheyGoOn) {
  LayerOptions options;
  options.vertex_budget = 4000;
  const Scene scene = testing::body_and_leg();
  const Hidden hidden = hide(*layer_parts(scene, options), scene);
  int flaps = 0;
  for (size_t f = 0; f < hidden.mesh.faces.size(); ++f) {
    if (!hidden.mesh.is_flap(f)) continue;
    ++flaps;
    EXPECT_EQ(hidden.mesh.face_part[f], 0);
    for (const int n : hidden.mesh.faces[f]) {
      const bool outline = hidden.mesh.node_role[n] == NodeRole::outline;
      EXPECT_EQ(hidden.inflation.u[n] > 0, !outline);
    }
  }
  EXPECT_GT(flaps, 50);
  EXPECT_LE(worst_dip_of(hidden), 0);
  expect_seen_unchanged(hidden);
}

TEST(HideSheets, DrawsNothingOutToSpikesWhereOutlinesCoincide) {
  Scene scene = testing::canvas();
  scene.parts.push_back(testing::part("legs", testing::rectangle(110, 200, 290, 370)));
  scene.parts.push_back(testing::part("body", testing::rectangle(60, 60, 340, 280)));
  scene.parts.push_back(testing::part("belly", testing::rectangle(120, 240, 280, 280)));
  for (const auto& [upper, lower] : {std::pair(1, 0), std::pair(2, 0), std::pair(2, 1)})
    scene.relations.push_back({upper, lower, RelationKind::equal, std::nullopt});
  LayerOptions options;
  options.vertex_budget = 4000;
  const Hidden hidden = hide(*layer_parts(scene, options), scene);
  EXPECT_LE(worst_dip_of(hidden), 1e-3);
  const auto lowest = [](const Ordering& ordering) {
    return *std::min_element(ordering.h.begin(), ordering.h.end());
  };
  EXPECT_GT(lowest(hidden.ordering), lowest(hidden.visible_ordering) - 40);
}

TEST(HideSheets, LeavesNothingInFrontOnRandomScenes) {
  LayerOptions options;
  options.vertex_budget = 3000;
  for (uint64_t seed = 1; seed <= 20; ++seed)
    for (const Scene& scene : {testing::random_scene(seed), testing::random_limbs(seed)}) {
      const Result<LayeredMesh> mesh = layer_parts(scene, options);
      if (!mesh) continue;
      const Hidden hidden = hide(*mesh, scene);
      EXPECT_LE(worst_dip_of(hidden), 1e-3) << seed;
      expect_seen_unchanged(hidden);
    }
}

}  // namespace
}  // namespace relievo::relief

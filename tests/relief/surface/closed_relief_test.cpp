#include <gtest/gtest.h>

#include "relief/session/build_relief.h"
#include "relief/surface/assemble_model.h"
#include "support/model_checks.h"
#include "support/random_scene.h"
#include "support/regions.h"

namespace relievo::relief {
namespace {

Model assemble(const Relief& relief, const Scene& scene, Visibility visibility) {
  ModelOptions options;
  options.visibility = visibility;
  auto model = assemble_model({relief.layers, relief.inflation, relief.ordering, scene}, options);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : to_string(model.error()));
  return model.ok() ? std::move(*model) : Model{};
}

/// What must hold of the models of any scene.
void expect_sound(const Scene& scene, int vertices) {
  ReliefOptions options;
  options.layers.vertex_budget = vertices;
  const auto relief = build_relief(scene, options);
  ASSERT_TRUE(relief.ok()) << to_string(relief.error());
  for (const Visibility visibility : {Visibility::relief, Visibility::orbit, Visibility::all}) {
    const Model model = assemble(*relief, scene, visibility);
    const EdgeCensus census = count_edges(model, false);
    EXPECT_EQ(census.crowded, 0);
    EXPECT_EQ(census.repeated, 0);
    for (const auto& t : sheet_triangles(model)) EXPECT_GT(front_area(model, {t}), 0);
    for (const Point3 n : model.normals) EXPECT_NEAR(norm(n), 1, 1e-12);
  }
  const Model model = assemble(*relief, scene, Visibility::relief);
  const SilhouetteCensus silhouette = count_silhouette(model, relief->layers);
  EXPECT_EQ(silhouette.elsewhere, 0);
  EXPECT_EQ(silhouette.along, silhouette.outline);
}

TEST(ClosedRelief, RandomScenesAreOpenAtTheSilhouetteOnly) {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_sound(testing::random_scene(seed), 1500);
  }
}

TEST(ClosedRelief, AnimalIsOpenAtTheSilhouetteOnly) {
  const auto scene = testing::read_regions(RELIEVO_SHARED_DATA "/regions/animal.json");
  if (!scene) GTEST_SKIP() << "the shared drawings are not here";
  expect_sound(*scene, 10000);
}

}  // namespace
}  // namespace relievo::relief

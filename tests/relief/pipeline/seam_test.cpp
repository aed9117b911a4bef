#include <gtest/gtest.h>

#include "support/mesh_checks.h"
#include "support/probe.h"
#include "support/regions.h"
#include "support/scenes.h"

namespace relievo {
namespace {

using namespace testing;

Relief build(const Scene& scene, double alpha0 = 0.1, int vertices = 20000) {
  ReliefOptions options;
  options.layers.vertex_budget = vertices;
  options.inflation.alpha0 = alpha0;
  return relief_of(scene, options);
}

TEST(Seam, HasNoKinkAcrossItsMiddle) {
  const Relief relief = build(body_and_leg());
  // One-sided slopes of second order at the seam.
  const double step = 3;
  const auto slope = [&](double side) {
    const double z0 = probe(relief, {200, 160}).h();
    const double z1 = probe(relief, {200, 160 + side * step}).h();
    const double z2 = probe(relief, {200, 160 + 2 * side * step}).h();
    return side * (4 * z1 - z2 - 3 * z0) / (2 * step);
  };
  EXPECT_LT(std::abs(slope(1) - slope(-1)), 0.02);
}

TEST(Seam, EndsAreAsHighAsTheMiddle) {
  const Relief relief = build(body_and_leg());
  const double middle = probe(relief, {200, 160}).h();
  EXPECT_GE(probe(relief, {180, 160}).h(), 0.9 * middle);
  EXPECT_GE(probe(relief, {220, 160}).h(), 0.9 * middle);
}

TEST(Seam, DirichletEndsMakeThePaperPits) {
  const Relief relief = build(body_and_leg(), 1);
  EXPECT_LT(probe(relief, {180, 160}).h(), 0.75 * probe(relief, {200, 160}).h());
}

/// The height at a join's end over what the lower part alone has there: below 1 is a pit.
double worst_pit(const Scene& scene, double alpha0) {
  Scene apart = scene;
  apart.joins.clear();
  const Relief joined = build(scene, alpha0);
  const Relief alone = build(apart, alpha0);
  double worst = 1e300;
  for (const Join& join : scene.joins)
    for (const Point2 end : {join.line.front(), join.line.back()})
      worst = std::min(worst, probe(joined, end).h() / probe(alone, end, join.lower).f);
  return worst;
}

TEST(Animal, IsSeamlessWithoutPits) {
  const auto scene = read_regions(RELIEVO_SHARED_DATA "/regions/animal.json");
  if (!scene) GTEST_SKIP() << "the shared drawings are not here";
  ASSERT_EQ(scene->joins.size(), 4u);
  EXPECT_GE(worst_pit(*scene, 0.1), 0.9);
  EXPECT_LE(worst_pit(*scene, 1), 0.7);
}

TEST(Animal, KeepsItsOrderEverywhere) {
  const auto scene = read_regions(RELIEVO_SHARED_DATA "/regions/animal.json");
  if (!scene) GTEST_SKIP() << "the shared drawings are not here";
  const Relief relief = build(*scene);
  const Manifoldness m = check_manifold(relief.layers);
  EXPECT_EQ(m.repeated_edges, 0);
  EXPECT_EQ(m.bow_ties, 0);
  EXPECT_LE(relief.ordering.max_violation, 1e-9);
  EXPECT_LE(relief.overlap_worst, 0.5);
}

}  // namespace
}  // namespace relievo

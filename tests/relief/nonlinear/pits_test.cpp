#include <gtest/gtest.h>

#include <algorithm>

#include "support/probe.h"
#include "support/regions.h"
#include "support/scenes.h"

namespace relievo::relief {
namespace {

using namespace testing;

Relief build(const Scene& scene, double lambda_bnd) {
  ReliefOptions options;
  options.method = Method::nonlinear;
  options.layers.attach = false;  // as in the paper
  options.layers.vertex_budget = 10000;
  options.nonlinear.lambda_bnd = lambda_bnd;
  auto relief = build_relief(scene, options);
  EXPECT_TRUE(relief.ok()) << (relief.ok() ? "" : to_string(relief.error()));
  return relief.ok() ? *relief : Relief();
}

/// Returns the lowest height at an end of a join relative to the height at its middle.
double worst_end(const Relief& relief, const Scene& scene) {
  double worst = 1e300;
  for (const Join& join : scene.joins) {
    const Point2 middle = 0.5 * (join.line.front() + join.line.back());
    for (const Point2 end : {join.line.front(), join.line.back()})
      worst = std::min(worst, probe(relief, end).h() / probe(relief, middle).h());
  }
  return worst;
}

TEST(Pits, AreNotInTheApproximateReliefAtThePapersValues) {
  const Scene scene = body_and_leg();  // all parts have c = 4 and d = 1
  ReliefOptions options;
  options.layers.vertex_budget = 10000;
  EXPECT_GT(worst_end(relief_of(scene, options), scene), 0.94);
  options.inflation.alpha0 = 1;
  EXPECT_LT(worst_end(relief_of(scene, options), scene), 0.7);
}

TEST(Pits, ShowAtTheLegWithStiffBoundsOnly) {
  const Scene scene = body_and_leg();
  EXPECT_LT(worst_end(build(scene, 100), scene), 0.75);
  EXPECT_GT(worst_end(build(scene, 0.01), scene), 0.95);
}

/// Returns the integral of f^2 over B. For minimisers it cannot grow with lambda_bnd.
double bound_integral(const Scene& scene, double lambda_bnd, bool glue) {
  ReliefOptions options;
  options.method = Method::nonlinear;
  options.layers.glue = glue;
  options.layers.vertex_budget = 3000;
  options.nonlinear.lambda_bnd = lambda_bnd;
  const Result<Relief> relief = build_relief(scene, options);
  EXPECT_TRUE(relief.ok()) << (relief.ok() ? "" : to_string(relief.error()));
  if (!relief.ok()) return -1;
  EXPECT_EQ(relief->nonlinear.status, SolveStatus::solved) << lambda_bnd;
  return relief->nonlinear.energy.boundary / lambda_bnd;
}

TEST(Pits, GrowWithLambdaWhetherOutlinesAreGluedOrNot) {
  Scene above = body_and_leg();
  above.relations.push_back({above.joins[0].upper, above.joins[0].lower, RelationKind::above, {}});
  const std::pair<Scene, bool> cases[] = {
      {body_and_leg(), true}, {body_and_leg(), false}, {above, true}};
  for (const auto& [scene, glue] : cases) {
    double last = bound_integral(scene, 0.01, glue);
    const double soft = last;
    for (const double lambda_bnd : {0.1, 1.0, 10.0, 100.0}) {
      const double next = bound_integral(scene, lambda_bnd, glue);
      EXPECT_LT(next, last) << lambda_bnd;
      last = next;
    }
    EXPECT_LT(last, 0.5 * soft);
  }
}

/// Returns the lowest inflation at a join's end relative to that of the lower part alone.
double worst_pit(const Scene& scene, double lambda_bnd) {
  Scene apart = scene;
  apart.joins.clear();
  const Relief joined = build(scene, lambda_bnd);
  const Relief alone = build(apart, lambda_bnd);
  double worst = 1e300;
  for (const Join& join : scene.joins)
    for (const Point2 end : {join.line.front(), join.line.back()})
      worst = std::min(worst, probe(joined, end).f / probe(alone, end, join.lower).f);
  return worst;
}

TEST(Pits, ShowAtTheAnimalWithStiffBoundsOnly) {
  const auto scene = read_regions(RELIEVO_SHARED_DATA "/regions/animal.json");
  if (!scene) GTEST_SKIP() << "the shared drawings are not here";
  EXPECT_LT(worst_pit(*scene, 100), 0.75);
  EXPECT_GT(worst_pit(*scene, 0.01), 0.9);
}

}  // namespace
}  // namespace relievo::relief

#include <gtest/gtest.h>

#include <algorithm>

#include "relief/discretisation/discretisation.h"
#include "relief/layers/layer_parts.h"
#include "relief/ordering/order_depth.h"
#include "relief/session/relief_session.h"
#include "support/random_scene.h"

// The cost of a reconstruction in operations, which is the same on any machine.

namespace relievo::relief {
namespace {

using namespace testing;

Ordering order_from(const Scene& scene, int vertices, const std::vector<DepthContact>& contacts) {
  LayerOptions layers;
  layers.vertex_budget = vertices;
  const LayeredMesh mesh = *layer_parts(scene, layers);
  const Discretisation discretisation = discretise(mesh);
  PoissonSystem poisson(mesh, discretisation, Refactorisation::complete, {});
  const Inflation inflation = *inflate({mesh, discretisation, scene}, {}, poisson);
  OrderingSystem system;
  system.contacts = contacts;
  return *order_depth({mesh, discretisation, scene}, inflation, {}, system);
}

TEST(OperationCounts, AColdOrderTakesAtMostTwentyFactorisations) {
  for (const uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8})
    for (const int vertices : {2000, 16000}) {
      const Ordering ordering = order_from(random_scene(seed), vertices, {});
      EXPECT_LE(ordering.report.factorisations, 20) << seed << " " << vertices;
      EXPECT_EQ(ordering.report.safeguard_steps, 0) << seed << " " << vertices;
      EXPECT_LE(ordering.report.stationarity, 1e-12);
      EXPECT_LE(ordering.report.primal, 0);
      EXPECT_LE(ordering.report.dual, 1e-12);
      EXPECT_LE(ordering.report.complementarity, 1e-12);
    }
}

TEST(OperationCounts, ACoarserMeshSavesHalfOfTheFactorisations) {
  int cold = 0;
  int from_coarse = 0;
  for (const uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    const Scene scene = random_scene(seed);
    ReliefOptions options;
    options.layers.vertex_budget = 2000;
    ReliefSession coarse(ReliefSession::Use::guess);
    ASSERT_TRUE(coarse.update(scene, options));
    cold += order_from(scene, 16000, {}).report.factorisations;
    const Ordering ordering = order_from(scene, 16000, coarse.contacts());
    from_coarse += ordering.report.factorisations;
    EXPECT_LE(ordering.report.factorisations, 10) << seed;
  }
  EXPECT_LE(2 * from_coarse, 1.2 * cold);
}

TEST(OperationCounts, EditsOfNumbersKeepEveryPattern) {
  const auto analyses = [](const ReliefSession& session) {
    const std::vector<StageTime>& times = session.relief().times;
    return std::count_if(times.begin(), times.end(),
                         [](const StageTime& time) { return time.stage == "analyse"; });
  };
  for (const uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    Scene scene = random_scene(seed);
    ReliefOptions options;
    options.layers.vertex_budget = 8000;
    ReliefSession session;
    ASSERT_TRUE(session.update(scene, options));
    EXPECT_GT(analyses(session), 0);
    const auto expect_few = [&](const char* edit, int most) {
      ASSERT_TRUE(session.update(scene, options));
      EXPECT_EQ(analyses(session), 0) << seed << " " << edit;
      EXPECT_LE(session.relief().ordering.report.factorisations, most) << seed << " " << edit;
    };
    scene.parts.back().c *= 1.1;
    expect_few("c", 6);
    scene.parts.back().d *= 0.9;
    expect_few("d", 6);
    scene.parts.front().lean = {0.1, 0.05};
    expect_few("lean", 6);
    options.inflation.alpha0 = 0.1;
    expect_few("alpha0", 6);
    options.inflation.rho *= 1.2;
    expect_few("rho", 6);
    scene.parts.front().c *= 2;
    expect_few("twice c", 8);
  }
}

}  // namespace
}  // namespace relievo::relief

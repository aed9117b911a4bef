#include "relief/ordering/pair_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "relief/discretisation/discretise.h"
#include "relief/inflation/inflate.h"
#include "support/stacked_parts.h"

namespace relievo {
namespace {

constexpr double epsilon = 1e-4;

std::vector<double> heights(DepthSystem& system, const ShiftMetric& metric,
                            const Eigen::VectorXd& f) {
  Ordering ordering;
  EXPECT_EQ(solve_heights(system, metric, f, ordering, {}), SolveStatus::solved);
  return ordering.h;
}

/// The pairs of the mesh without those of the parts from `front` on.
std::vector<DepthPair> pairs_behind(const LayeredMesh& mesh, int front) {
  std::vector<DepthPair> pairs = mesh.constraints;
  pairs.erase(
      std::remove_if(pairs.begin(), pairs.end(),
                     [&](const DepthPair& pair) { return mesh.node_part[pair.upper] >= front; }),
      pairs.end());
  return pairs;
}

TEST(PairSelection, GivesTheHeightsOfASystemBuiltForThePairs) {
  const LayeredMesh mesh = testing::scattered_discs(12, 25);
  const Eigen::VectorXd f = inflated_heights(inflate(mesh, testing::scene_of(mesh), {})->u);
  const ShiftMetric metric = make_shift_metric(discretise(mesh), epsilon);
  const auto build = [&](const std::vector<DepthPair>& pairs) {
    return make_depth_system(make_depth_problem(mesh.node_part, pairs), metric, {}, {}, {});
  };
  DepthSystem system = build(mesh.constraints);
  const std::vector<double> all = heights(system, metric, f);
  for (const int front : {11, 7, 3}) {
    const std::vector<DepthPair> pairs = pairs_behind(mesh, front);
    ASSERT_LT(pairs.size(), mesh.constraints.size());
    ASSERT_TRUE(select_pairs(mesh.node_part, pairs, system));
    DepthSystem fresh = build(pairs);
    const std::vector<double> expected = heights(fresh, metric, f);
    const std::vector<double> selected = heights(system, metric, f);
    for (size_t n = 0; n < selected.size(); ++n) EXPECT_NEAR(selected[n], expected[n], 1e-6);
    EXPECT_NE(selected, all);
  }
  ASSERT_TRUE(select_pairs(mesh.node_part, mesh.constraints, system));
  EXPECT_EQ(heights(system, metric, f), all);
}

TEST(PairSelection, RefusesPairsThatTheSystemDoesNotHave) {
  const LayeredMesh mesh = testing::scattered_discs(12, 25);
  const ShiftMetric metric = make_shift_metric(discretise(mesh), epsilon);
  const std::vector<DepthPair> some = pairs_behind(mesh, 7);
  DepthSystem system =
      make_depth_system(make_depth_problem(mesh.node_part, some), metric, {}, {}, {});
  const std::vector<uint8_t> bounded = system.qp.bounded;
  EXPECT_FALSE(select_pairs(mesh.node_part, mesh.constraints, system));
  std::vector<DepthPair> merged = some;
  merged[0].equal = true;
  EXPECT_FALSE(select_pairs(mesh.node_part, merged, system));
  EXPECT_EQ(system.qp.bounded, bounded);
}

}  // namespace
}  // namespace relievo

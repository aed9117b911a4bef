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

int count_equal(const DepthSystem& system) {
  const std::vector<DepthGap>& gaps = system.problem.forest.gaps;
  return static_cast<int>(
      std::count_if(gaps.begin(), gaps.end(), [](const DepthGap& gap) { return gap.equal; }));
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
    ASSERT_TRUE(select_pairs(mesh.node_part, pairs, metric, system));
    DepthSystem fresh = build(pairs);
    const std::vector<double> expected = heights(fresh, metric, f);
    const std::vector<double> selected = heights(system, metric, f);
    for (size_t n = 0; n < selected.size(); ++n) EXPECT_NEAR(selected[n], expected[n], 1e-7);
    EXPECT_NE(selected, all);
  }
  ASSERT_TRUE(select_pairs(mesh.node_part, mesh.constraints, metric, system));
  EXPECT_EQ(heights(system, metric, f), all);
}

TEST(PairSelection, SplitsWhatWasEqualAndFindsWhatWasImplied) {
  const LayeredMesh mesh = testing::scattered_discs(12, 25);
  const Eigen::VectorXd f = inflated_heights(inflate(mesh, testing::scene_of(mesh), {})->u);
  const ShiftMetric metric = make_shift_metric(discretise(mesh), epsilon);
  const auto build = [&](const std::vector<DepthPair>& pairs) {
    return make_depth_system(make_depth_problem(mesh.node_part, pairs), metric, {}, {}, {});
  };
  std::vector<DepthPair> changed = mesh.constraints;
  for (DepthPair& pair : changed) pair.equal = mesh.node_part[pair.upper] % 3 == 0;
  DepthSystem system = build(changed);
  ASSERT_EQ(count_equal(system), count_equal(build(changed)));
  ASSERT_GT(count_equal(system), 0);
  const auto expect_heights_of = [&](const std::vector<DepthPair>& pairs) {
    ASSERT_TRUE(select_pairs(mesh.node_part, pairs, metric, system));
    DepthSystem fresh = build(pairs);
    ASSERT_EQ(count_equal(system), count_equal(fresh));
    const std::vector<double> expected = heights(fresh, metric, f);
    const std::vector<double> selected = heights(system, metric, f);
    for (size_t n = 0; n < selected.size(); ++n) EXPECT_NEAR(selected[n], expected[n], 1e-7);
  };
  expect_heights_of(mesh.constraints);
  EXPECT_EQ(count_equal(system), 0);
  // Without the parts in between, a pair that they implied counts for itself.
  std::vector<DepthPair> over = mesh.constraints;
  over.erase(std::remove_if(over.begin(), over.end(),
                            [&](const DepthPair& pair) {
                              return mesh.node_part[pair.upper] % 2 !=
                                     mesh.node_part[pair.lower] % 2;
                            }),
             over.end());
  ASSERT_LT(over.size(), mesh.constraints.size());
  expect_heights_of(over);
  expect_heights_of(changed);
}

TEST(PairSelection, RefusesPairsThatLinkOtherNodes) {
  const LayeredMesh mesh = testing::scattered_discs(12, 25);
  const ShiftMetric metric = make_shift_metric(discretise(mesh), epsilon);
  const std::vector<DepthPair> some = pairs_behind(mesh, 7);
  DepthSystem system =
      make_depth_system(make_depth_problem(mesh.node_part, some), metric, {}, {}, {});
  const std::vector<DepthGap> gaps = system.problem.forest.gaps;
  EXPECT_FALSE(select_pairs(mesh.node_part, mesh.constraints, metric, system));
  EXPECT_EQ(system.problem.forest.gaps, gaps);
}

}  // namespace
}  // namespace relievo

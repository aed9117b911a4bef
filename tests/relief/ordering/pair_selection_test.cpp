#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflate.h"
#include "relief/ordering/order_depth.h"
#include "support/solve_once.h"
#include "support/stacked_parts.h"

namespace relievo::relief {
namespace {

constexpr double epsilon = 1e-4;

int count_equal(const DepthSystem& system) {
  const std::vector<DepthGap>& gaps = system.forest.gaps;
  return static_cast<int>(
      std::count_if(gaps.begin(), gaps.end(), [](const DepthGap& gap) { return gap.equal; }));
}

/// Returns the pairs of the mesh without those of the parts from `front` on.
std::vector<DepthPair> pairs_behind(const LayeredMesh& mesh, int front) {
  std::vector<DepthPair> pairs = mesh.constraints;
  pairs.erase(
      std::remove_if(pairs.begin(), pairs.end(),
                     [&](const DepthPair& pair) { return mesh.node_part[pair.upper] >= front; }),
      pairs.end());
  return pairs;
}

class PairSelection : public ::testing::Test {
 protected:
  DepthSystem build(const std::vector<DepthPair>& pairs) const {
    return make_depth_system(build_depth_forest(mesh_.node_part, pairs), metric_, {}, {}, {});
  }
  bool select(const std::vector<DepthPair>& pairs, DepthSystem& system) const {
    return select_pairs(mesh_.node_part, pairs, metric_, system);
  }
  std::vector<double> heights(DepthSystem& system) const {
    Ordering ordering;
    EXPECT_EQ(solve_heights(system, metric_, f_, ordering, {}), SolveStatus::solved);
    return ordering.h;
  }

  const LayeredMesh mesh_ = testing::scattered_discs(12, 25);
  const Eigen::VectorXd f_ = inflated_heights(inflate(mesh_, testing::scene_of(mesh_), {})->u);
  const ShiftMetric metric_ = make_shift_metric(discretise(mesh_), epsilon);
};

TEST_F(PairSelection, GivesTheHeightsOfASystemBuiltForThePairs) {
  DepthSystem system = build(mesh_.constraints);
  const std::vector<double> all = heights(system);
  for (const int front : {11, 7, 3}) {
    const std::vector<DepthPair> pairs = pairs_behind(mesh_, front);
    ASSERT_LT(pairs.size(), mesh_.constraints.size());
    ASSERT_TRUE(select(pairs, system));
    DepthSystem fresh = build(pairs);
    const std::vector<double> expected = heights(fresh);
    const std::vector<double> selected = heights(system);
    for (size_t n = 0; n < selected.size(); ++n) EXPECT_NEAR(selected[n], expected[n], 1e-7);
    EXPECT_NE(selected, all);
  }
  ASSERT_TRUE(select(mesh_.constraints, system));
  EXPECT_EQ(heights(system), all);
}

TEST_F(PairSelection, SplitsWhatWasEqualAndFindsWhatWasImplied) {
  std::vector<DepthPair> changed = mesh_.constraints;
  for (DepthPair& pair : changed) pair.equal = mesh_.node_part[pair.upper] % 3 == 0;
  // Without the pairs in between, a pair that they implied is not dropped.
  std::vector<DepthPair> over = mesh_.constraints;
  const auto next_but_one = [&](const DepthPair& pair) {
    return (mesh_.node_part[pair.upper] - mesh_.node_part[pair.lower]) % 2 == 0;
  };
  over.erase(std::remove_if(over.begin(), over.end(), std::not_fn(next_but_one)), over.end());
  ASSERT_LT(over.size(), mesh_.constraints.size());
  DepthSystem system = build(changed);
  ASSERT_GT(count_equal(system), 0);
  for (const std::vector<DepthPair>& pairs : {mesh_.constraints, over, changed}) {
    ASSERT_TRUE(select(pairs, system));
    DepthSystem fresh = build(pairs);
    ASSERT_EQ(count_equal(system), count_equal(fresh));
    const std::vector<double> expected = heights(fresh);
    const std::vector<double> selected = heights(system);
    for (size_t n = 0; n < selected.size(); ++n) EXPECT_NEAR(selected[n], expected[n], 1e-7);
  }
}

TEST_F(PairSelection, RefusesPairsThatLinkOtherNodes) {
  DepthSystem system = build(pairs_behind(mesh_, 7));
  const std::vector<DepthGap> gaps = system.forest.gaps;
  EXPECT_FALSE(select(mesh_.constraints, system));
  EXPECT_EQ(system.forest.gaps, gaps);
}

}  // namespace
}  // namespace relievo::relief

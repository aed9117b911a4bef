
#include "understanding/stacking/order_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "support/label_maps.h"

namespace relievo::understanding {
namespace {

using namespace testing;

OrderArrow arrow(int upper, int lower, double confidence, bool user) {
  return {static_cast<PartLabel>(upper), static_cast<PartLabel>(lower), confidence, user};
}
OrderArrow guess(int upper, int lower, double confidence) {
  return arrow(upper, lower, confidence, false);
}
OrderArrow said(int upper, int lower) { return arrow(upper, lower, 1, true); }

/// The labels 0 to `count` - 1, so that they are indices as well.
std::vector<PartLabel> parts_of(int count) {
  std::vector<PartLabel> labels(count);
  std::iota(labels.begin(), labels.end(), PartLabel{0});
  return labels;
}

/// Whether every kept arrow points from the front to the back.
bool obeys(const std::vector<int>& order, const std::vector<OrderArrow>& arrows) {
  std::vector<int> rank(order.size());
  for (size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<int>(i);
  for (const OrderArrow& arrow : arrows)
    if (arrow.kept && rank[arrow.upper] < rank[arrow.lower]) return false;
  return true;
}

TEST(OrderGraph, CutsACycleAtItsWeakestGuess) {
  std::vector<OrderArrow> arrows = {guess(1, 0, 0.9), guess(2, 1, 0.3), guess(0, 2, 0.6)};
  ASSERT_TRUE(break_cycles(parts_of(3), arrows).ok());
  EXPECT_TRUE(arrows[0].kept);
  EXPECT_FALSE(arrows[1].kept);
  EXPECT_TRUE(arrows[2].kept);
}

TEST(OrderGraph, KeepsTheArrowsOfTheUser) {
  std::vector<OrderArrow> arrows = {said(1, 0), said(2, 1), guess(0, 2, 0.99)};
  ASSERT_TRUE(break_cycles(parts_of(3), arrows).ok());
  EXPECT_TRUE(arrows[0].kept);
  EXPECT_TRUE(arrows[1].kept);
  EXPECT_FALSE(arrows[2].kept);
}

TEST(OrderGraph, RefusesACircleOfUserArrows) {
  std::vector<OrderArrow> arrows = {said(7, 5), said(9, 7), said(5, 9)};
  const Status status = break_cycles({5, 7, 9}, arrows);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::contradiction);
  EXPECT_EQ(status.error().where, "label 5 over label 9");
}

TEST(OrderGraph, LeavesArrowsOutsideCyclesAlone) {
  std::vector<OrderArrow> arrows = {guess(1, 0, 0.5), guess(0, 1, 0.4), guess(3, 2, 0.01)};
  ASSERT_TRUE(break_cycles(parts_of(4), arrows).ok());
  EXPECT_FALSE(arrows[1].kept);
  EXPECT_TRUE(arrows[2].kept);
}

TEST(OrderGraph, OrdersRandomGraphs) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int parts = draw(random, 2, 12);
    std::vector<OrderArrow> arrows;
    for (int k = draw(random, 0, 30); k > 0; --k) {
      const int a = draw(random, 0, parts - 1);
      const int b = draw(random, 0, parts - 1);
      // The user's arrows agree with each other: larger parts in front.
      if (a == b) continue;
      arrows.push_back(draw(random, 0, 3) == 0 ? said(std::max(a, b), std::min(a, b))
                                               : guess(a, b, draw(random, 1, 99) / 100.0));
    }
    ASSERT_TRUE(break_cycles(parts_of(parts), arrows).ok());
    for (const OrderArrow& arrow : arrows) EXPECT_TRUE(arrow.kept || !arrow.user);
    const std::vector<double> area(parts, 1);
    const std::vector<int> order = sort_back_to_front(parts_of(parts), area, arrows);
    EXPECT_EQ(order.size(), static_cast<size_t>(parts));
    EXPECT_TRUE(obeys(order, arrows));
  }
}

double likelihood(const std::vector<int>& order, const std::vector<std::vector<double>>& log_odds) {
  double sum = 0;
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t k = 0; k < i; ++k) sum += log_odds[order[i]][order[k]];
  return sum;
}

TEST(OrderGraph, LikelierOrdersAreNeverWorseAndMostlyBest) {
  std::mt19937 random(2);
  int best_found = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const int parts = draw(random, 2, 6);
    std::vector<std::vector<double>> odds(parts, std::vector<double>(parts, 0));
    for (int a = 0; a < parts; ++a)
      for (int b = 0; b < a; ++b) {
        odds[a][b] = draw(random, -300, 300) / 100.0;
        odds[b][a] = -odds[a][b];
      }
    std::vector<int> order(parts);
    std::iota(order.begin(), order.end(), 0);
    const double found = likelihood(likelier_order(order, odds), odds);
    EXPECT_GE(found, likelihood(order, odds));
    double best = found;
    do best = std::max(best, likelihood(order, odds));
    while (std::next_permutation(order.begin(), order.end()));
    best_found += found > best - 1e-9 ? 1 : 0;
  }
  EXPECT_GE(best_found, 80);
}

TEST(OrderGraph, PutsTheLargestOfUnrelatedPartsBehind) {
  EXPECT_EQ(sort_back_to_front({1, 2, 3}, {5, 9, 7}, {}), (std::vector<int>{1, 2, 0}));
}

}  // namespace
}  // namespace relievo::understanding

#include "understanding/areas/region_features.h"

#include <gtest/gtest.h>

#include <random>

#include "support/ink_drawing.h"
#include "understanding/areas/boosted_trees.h"
#include "understanding/areas/find_basins.h"
#include "understanding/perception/built_in_network.h"

namespace relievo::understanding {
namespace {

TEST(BoostedTrees, AddTheLeavesThatFeaturesLeadTo) {
  // A leaf; a tree that asks for the first feature, then for the second.
  const TreeNode nodes[] = {{-1, 0, 10}, {0, 5, 0.5F}, {1, 4, -1.0F},
                            {-1, 0, 1},  {-1, 0, 2},   {-1, 0, 3}};
  const auto sum = [&](double first, double second) {
    return sum_of_leaves(nodes, std::array{first, second});
  };
  EXPECT_EQ(sum(0.5, -1), 11) << "thresholds belong to the left branch";
  EXPECT_EQ(sum(0, 0), 12);
  EXPECT_EQ(sum(0.6, -5), 13);
  EXPECT_EQ(sum_of_leaves(std::span(nodes).first(1), {}), 10);
}

/// A figure of many areas on a meadow, with lines, fills and texture.
Basins busy_basins() {
  InkDrawing ink(400, 400);
  ink.disc({200, 150}, 90, 240, 180, 60).circle({200, 150}, 90).circle({200, 300}, 70);
  ink.disc({180, 130}, 14, 40, 90, 200).line({0, 350}, {400, 340}, 3).line({200, 60}, {200, 240});
  for (int k = 0; k < 12; ++k) ink.line({20.0 + 30 * k, 345}, {25.0 + 30 * k, 320}, 2);
  auto basins = find_basins(ink.drawing(), built_in_network());
  EXPECT_TRUE(basins.ok());
  return std::move(*basins);
}

TEST(RegionFeatures, OfUnitedRegionsDoNotDependOnTheOrderOfUniting) {
  const Basins basins = busy_basins();
  const DrawingMeasure drawing = measure_drawing(basins);
  std::mt19937 random(1);
  std::vector<BasinBorder> unions = basins.borders;
  ASSERT_GT(unions.size(), 20U);
  std::shuffle(unions.begin(), unions.end(), random);
  unions.resize(unions.size() / 3);
  RegionMerging forwards(basins);
  RegionMerging backwards(basins);
  const auto unite = [](RegionMerging& regions, const BasinBorder& border) {
    const int a = regions.region_of(border.a);
    const int b = regions.region_of(border.b);
    if (a != b) regions.unite(a, b);
  };
  for (const BasinBorder& border : unions) unite(forwards, border);
  for (auto border = unions.rbegin(); border != unions.rend(); ++border) unite(backwards, *border);
  for (int r = 0; r < forwards.count(); ++r) {
    if (!forwards.is_region(r)) continue;
    const int same = backwards.region_of(r);
    const RegionFeatures a = features_of(forwards, drawing, r);
    const RegionFeatures b = features_of(backwards, drawing, same);
    for (size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-9) << k;
    for (const auto& [neighbour, border] : forwards.borders(r)) {
      const PairFeatures p = features_of(forwards, drawing, r, neighbour);
      const PairFeatures q = features_of(backwards, drawing, same, backwards.region_of(neighbour));
      for (size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(p[k], q[k], 1e-9) << k;
    }
  }
}

TEST(RegionFeatures, OfAPairDoNotDependOnItsOrder) {
  const Basins basins = busy_basins();
  const DrawingMeasure drawing = measure_drawing(basins);
  const RegionMerging regions(basins);
  for (const BasinBorder& border : basins.borders) {
    const PairFeatures p = features_of(regions, drawing, border.a, border.b);
    const PairFeatures q = features_of(regions, drawing, border.b, border.a);
    if (regions.region(border.a).area == regions.region(border.b).area) continue;
    for (size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(p[k], q[k], 1e-9) << k;
  }
}

TEST(Merger, StopsWhereAllNeighboursAreLikelierTwoParts) {
  const Basins basins = busy_basins();
  const DrawingMeasure drawing = measure_drawing(basins);
  RegionMerging regions(basins);
  Merger merger(regions, [&](int a, int b) { return one_part_odds(regions, drawing, a, b); });
  int unions = 0;
  while (merger.unite_next()) ++unions;
  EXPECT_GT(unions, 0);
  for (int r = 0; r < regions.count(); ++r)
    for (const auto& [neighbour, border] : regions.borders(r))
      EXPECT_LE(one_part_odds(regions, drawing, r, neighbour), 0);
}

}  // namespace
}  // namespace relievo::understanding

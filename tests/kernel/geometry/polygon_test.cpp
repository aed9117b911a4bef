#include "kernel/geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace relievo {
namespace {

Ring square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

TEST(Polygon, AreaIsPositiveClockwiseOnScreen) {
  EXPECT_DOUBLE_EQ(signed_area(square(3, 4, 2)), 4);
  Ring reversed = square(3, 4, 2);
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_DOUBLE_EQ(signed_area(reversed), -4);
}

TEST(Polygon, WindingNumberCountsTurns) {
  Ring twice = square(0, 0, 1);
  const Ring once = twice;
  twice.insert(twice.end(), once.begin(), once.end());
  EXPECT_EQ(winding_number(once, {0.5, 0.5}), 1);
  EXPECT_EQ(winding_number(twice, {0.5, 0.5}), 2);
  EXPECT_EQ(winding_number(twice, {1.5, 0.5}), 0);
}

TEST(Polygon, NestedRingsAlternate) {
  Outline outline = {square(0, 0, 9), square(1, 1, 7), square(2, 2, 5)};
  orient_by_nesting(outline);
  EXPECT_GT(signed_area(outline[0]), 0);
  EXPECT_LT(signed_area(outline[1]), 0);
  EXPECT_GT(signed_area(outline[2]), 0);
  EXPECT_TRUE(contains(outline, {0.5, 0.5}));
  EXPECT_FALSE(contains(outline, {1.5, 1.5}));
  EXPECT_TRUE(contains(outline, {4, 4}));
}

TEST(Polygon, ConvexHullIsTheLeastConvexRingAround) {
  std::mt19937 random(7);
  std::vector<Point2> points;
  for (int i = 0; i < 300; ++i) {
    const double x = static_cast<double>(random() % 41);
    points.push_back({x, static_cast<double>(random() % 31)});
  }
  const Ring hull = convex_hull(points);
  for (size_t i = 0; i < hull.size(); ++i) {
    const Point2 a = hull[i];
    const Point2 b = hull[(i + 1) % hull.size()];
    EXPECT_GT(cross(b - a, hull[(i + 2) % hull.size()] - b), 0) << i;
    for (const Point2 p : points) EXPECT_GE(cross(b - a, p - a), 0) << i;
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [a](Point2 p) { return p == a; })) << i;
  }
  EXPECT_GT(signed_area(hull), 0);
  std::shuffle(points.begin(), points.end(), random);
  EXPECT_EQ(convex_hull(points), hull);
}

}  // namespace
}  // namespace relievo

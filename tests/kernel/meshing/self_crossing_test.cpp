#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernel/meshing/splice_curves.h"
#include "relievo/point.h"

namespace relievo {
namespace {

/// Makes the star polygon {n/k}: every k-th corner of a regular n-gon of radius 1.
Ring star(int n, int k) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i * k / n;
    ring.push_back({std::cos(angle), std::sin(angle)});
  }
  return ring;
}

TEST(SelfCrossing, IsFoundWhereEdgesCross) {
  const auto place = find_self_crossing({{{0, 0}, {4, 2}, {4, 0}, {0, 2}}});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, 2, 1e-12);
  EXPECT_NEAR(place->y, 1, 1e-12);
}

/// The edges of {n/k} cross on the circles of radius cos(pi k/n) / cos(pi j/n), 0 < j < k.
TEST(SelfCrossing, OfAStarLiesOnItsInnerPolygon) {
  const auto place = find_self_crossing({star(7, 2)});
  ASSERT_TRUE(place);
  EXPECT_NEAR(norm(*place), std::cos(2 * std::numbers::pi / 7) / std::cos(std::numbers::pi / 7),
              1e-12);
  EXPECT_FALSE(find_self_crossing({star(7, 1)}));
}

TEST(SelfCrossing, IsSeenBetweenRingsButNotWhereTheyTouch) {
  const Ring lower = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_TRUE(find_self_crossing({lower, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}}));
  EXPECT_FALSE(find_self_crossing({lower, {{2, 2}, {3, 2}, {3, 3}, {2, 3}}}));
  EXPECT_FALSE(find_self_crossing({lower, {{0.5, 0.5}, {1, 0.5}, {1, 1}}}));
  EXPECT_FALSE(find_self_crossing({}));
}

}  // namespace
}  // namespace relievo

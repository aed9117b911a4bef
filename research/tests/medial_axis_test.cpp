#include "research/rivals/medial_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_limbs.h"
#include "support/scenes.h"

namespace relievo::research {
namespace {

MedialAxis axis_of(const Outline& outline, double spacing = 2) {
  const auto axis = medial_axis(outline, spacing);
  EXPECT_TRUE(axis);
  return *axis;
}

TEST(MedialAxis, OfADiscIsItsMiddle) {
  const MedialAxis axis = axis_of({testing::circle({200, 180}, 70, 400)});
  ASSERT_EQ(axis.centre.size(), 1U);
  EXPECT_TRUE(axis.edges.empty());
  EXPECT_NEAR(axis.radius[0], 70, 0.05);
  EXPECT_NEAR(distance(axis.centre[0], {200, 180}), 0, 0.05);
}

TEST(MedialAxis, OfACapsuleIsItsSegment) {
  const MedialAxis axis = axis_of({testing::capsule({100, 200}, 0, 200, 25)}, 1);
  ASSERT_GT(axis.edges.size(), 8U);
  double left = 1000;
  double right = 0;
  for (size_t i = 0; i < axis.centre.size(); ++i) {
    EXPECT_NEAR(axis.radius[i], 25, 0.5);
    EXPECT_NEAR(axis.centre[i].y, 200, 0.5);
    left = std::min(left, axis.centre[i].x);
    right = std::max(right, axis.centre[i].x);
  }
  EXPECT_NEAR(left, 100, 6);
  EXPECT_NEAR(right, 300, 6);
}

TEST(MedialAxis, OfARingGoesAround) {
  Ring hole = testing::circle({200, 200}, 60, 300);
  std::reverse(hole.begin(), hole.end());
  const MedialAxis axis = axis_of({testing::circle({200, 200}, 100, 300), hole});
  ASSERT_EQ(axis.edges.size(), axis.centre.size());
  for (size_t i = 0; i < axis.centre.size(); ++i) {
    EXPECT_NEAR(distance(axis.centre[i], {200, 200}), 80, 0.5);
    EXPECT_NEAR(axis.radius[i], 20, 0.5);
  }
}

TEST(MedialAxis, OfACrossHasOneForkAndFourEnds) {
  const Ring cross = {{180, 100}, {220, 100}, {220, 180}, {300, 180}, {300, 220}, {220, 220},
                      {220, 300}, {180, 300}, {180, 220}, {100, 220}, {100, 180}, {180, 180}};
  const MedialAxis axis = axis_of({cross}, 1);
  std::vector<int> degree(axis.centre.size(), 0);
  for (const auto& edge : axis.edges)
    for (const int end : edge) ++degree[end];
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 1), 4);
  for (size_t i = 0; i < degree.size(); ++i) {
    if (degree[i] > 2) {
      EXPECT_NEAR(distance(axis.centre[i], {200, 200}), 0, 12);
    }
  }
}

TEST(MedialAxis, DoesNotMindNoise) {
  Ring ring = testing::capsule({100, 200}, 0, 200, 25);
  for (size_t i = 0; i < ring.size(); ++i) ring[i].y += i % 2 == 0 ? 0.4 : -0.4;
  const MedialAxis axis = axis_of({ring}, 1);
  for (size_t i = 0; i < axis.centre.size(); ++i) EXPECT_NEAR(axis.centre[i].y, 200, 1.5);
}

TEST(MedialAxis, OfNothingIsEmpty) { EXPECT_TRUE(axis_of({}).centre.empty()); }

}  // namespace
}  // namespace relievo::research

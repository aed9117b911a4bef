#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "research/rivals/contour.h"
#include "support/random_scene.h"

namespace relievo::research {
namespace {

/// The integral as it is published, by the midpoint rule.
double by_quadrature(const Bone& bone, Point3 p, int steps) {
  const Point3 d = bone.b - bone.a;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps;
    const double tau = bone.radius_a + t * (bone.radius_b - bone.radius_a);
    const double x = norm(p - (bone.a + t * d)) / tau;
    if (x < 2) sum += std::pow(1 - x * x / 4, 3) / tau;
  }
  return 1.49683 * sum * norm(d) / steps;
}

Point3 random_point(testing::Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

TEST(Convolution, IsThePublishedIntegral) {
  testing::Random random(7);
  int inside = 0;
  for (int i = 0; i < 200; ++i) {
    const Bone bone{random_point(random, 3), random_point(random, 3), random.uniform(0.5, 2),
                    random.uniform(0.5, 2)};
    const Point3 p = random_point(random, 4);
    const double wanted = by_quadrature(bone, p, 40000);
    EXPECT_NEAR(field(bone, p), wanted, 1e-5 * std::max(1.0, wanted)) << i;
    inside += wanted > 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 40);
}

TEST(Convolution, IsOneAtTheRadiusOfALongLine) {
  const Bone line{{-100, 0, 0}, {100, 0, 0}, 3, 3};
  EXPECT_NEAR(field(line, {0, 3, 0}), 1, 1e-5);
  EXPECT_NEAR(field(line, {5, 0, -3}), 1, 1e-5);
  EXPECT_EQ(field(line, {0, 6.01, 0}), 0);
}

TEST(Convolution, IsOneAtTheRadiusOfAPoint) {
  const Bone point{{1, 2, 3}, {1, 2, 3}, 4, 4};
  EXPECT_NEAR(field(point, {1, 6, 3}), 1, 1e-12);
  EXPECT_GT(field(point, {1, 5, 3}), 1);
  EXPECT_LT(field(point, {1, 7, 3}), 1);
}

TEST(Convolution, DoesNotDependOnTheUnit) {
  const Bone bone{{0, 0, 0}, {4, 1, 0}, 1, 2};
  const Point3 p{2, 1.5, 1};
  const Bone scaled{10 * bone.a, 10 * bone.b, 10 * bone.radius_a, 10 * bone.radius_b};
  EXPECT_NEAR(field(bone, p), field(scaled, 10 * p), 1e-12);
}

TEST(Convolution, SumsItsBonesWherever) {
  testing::Random random(11);
  std::vector<Bone> bones;
  for (int i = 0; i < 30; ++i) {
    const Point3 a = random_point(random, 50);
    bones.push_back(
        {a, a + random_point(random, 5), random.uniform(0.5, 6), random.uniform(0.5, 6)});
  }
  const Convolution convolution(bones);
  for (int i = 0; i < 500; ++i) {
    const Point3 p = i < 30 ? bones[i].b : random_point(random, 70);
    double sum = 0;
    for (const Bone& bone : bones) sum += field(bone, p);
    EXPECT_NEAR(convolution.value(p), sum, 1e-12);
  }
  EXPECT_EQ(Convolution({}).value({0, 0, 0}), 0);
}

TEST(Convolution, GradientPointsInwardsFromTheSurface) {
  const Convolution ball({{{0, 0, 0}, {0, 0, 0}, 2, 2}});
  const Point3 slope = ball.gradient({2, 0, 0});
  // d/dr of (64/27) (1 - r^2 / 16)^3 at r = 2.
  EXPECT_NEAR(slope.x, -1, 1e-4);
  EXPECT_NEAR(slope.y, 0, 1e-8);
  EXPECT_NEAR(ball.radius({2, 0, 0}), 2, 1e-12);
}

}  // namespace
}  // namespace relievo::research

#include "kernel/image/level_contours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace relievo {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Makes the field of the radius minus the distance from the centre of the image.
ImageF cone(int side, double radius) {
  ImageF field(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      field.at(x, y) =
          static_cast<float>(radius - std::hypot(x + 0.5 - side / 2.0, y + 0.5 - side / 2.0));
  return field;
}

ImageF noise(int width, int height, uint32_t seed) {
  ImageF field(width, height, 1);
  for (float& value : field.pixels) {
    seed = seed * 1664525U + 1013904223U;
    value = static_cast<float>(seed >> 8) / 16777216.0F + 1e-4F;
  }
  return field;
}

TEST(LevelContours, TheRadiusOfACircleConvergesWithSecondOrder) {
  double previous = 0;
  for (const int side : {32, 64, 128}) {
    const double radius = 0.4 * side;
    const Outline rings = level_contours(cone(side, radius), 0, -1e3F);
    ASSERT_EQ(rings.size(), 1u);
    const double error = std::abs(std::sqrt(signed_area(rings[0]) / pi) / radius - 1);
    EXPECT_LT(error, 0.01);
    if (previous > 0) {
      EXPECT_GT(std::log2(previous / error), 1.7);
    }
    previous = error;
  }
}

TEST(LevelContours, APixelAboveTheLevelIsADiamondAroundItsCentre) {
  ImageF field(3, 3, 1);
  field.at(1, 1) = 1;
  const Outline rings = level_contours(field, 0.5F);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0], (Ring{{1, 1.5}, {1.5, 1}, {2, 1.5}, {1.5, 2}}));
}

TEST(LevelContours, WhatFillsTheImageEndsAtItsBorder) {
  const Outline rings = level_contours(ImageF(4, 2, 1, 1.0F), 0.5F);
  ASSERT_EQ(rings.size(), 1u);
  const Box2 box = bounding_box(rings);
  EXPECT_EQ(box.min, (Point2{0, 0}));
  EXPECT_EQ(box.max, (Point2{4, 2}));
}

TEST(LevelContours, HolesRunAgainstWhatIsAroundThem) {
  ImageF field(9, 9, 1, 1.0F);
  field.at(4, 4) = 0;
  const Outline rings = level_contours(field, 0.5F);
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_GT(signed_area(rings[0]), 70);
  EXPECT_NEAR(signed_area(rings[1]), -0.5, 1e-12);
}

TEST(LevelContours, TheMeanDecidesBetweenDiagonalNeighbours) {
  ImageF field(2, 2, 1);
  field.at(0, 0) = field.at(1, 1) = 1;
  EXPECT_EQ(level_contours(field, 0.6F).size(), 2u);
  EXPECT_EQ(level_contours(field, 0.4F).size(), 1u);
}

TEST(LevelContours, SeparateWhatIsAboveFromWhatIsBelowInNoise) {
  for (uint32_t seed = 1; seed <= 40; ++seed) {
    const ImageF field = noise(13, 9, seed);
    const float level = 0.2F + 0.015F * static_cast<float>(seed);
    const Outline rings = level_contours(field, level);
    for (int y = 0; y < field.height; ++y)
      for (int x = 0; x < field.width; ++x) {
        int winding = 0;
        for (const Ring& ring : rings) winding += winding_number(ring, {x + 0.5, y + 0.5});
        EXPECT_EQ(winding, field.at(x, y) >= level ? 1 : 0) << seed << ": " << x << " " << y;
      }
    std::set<std::pair<double, double>> points;
    for (const Ring& ring : rings)
      for (const Point2 p : ring) EXPECT_TRUE(points.emplace(p.x, p.y).second);
  }
}

TEST(LevelContours, AnEmptyImageHasNone) {
  EXPECT_TRUE(level_contours(ImageF(0, 0, 1), 0.5F).empty());
  EXPECT_TRUE(level_contours(ImageF(5, 5, 1), 0.5F).empty());
}

}  // namespace
}  // namespace relievo

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "io/svg/svg_region.h"

namespace relievo {
namespace {

using std::numbers::pi;
const Box2 canvas{{0, 0}, {100, 100}};

Polyline box(double x, double y, double width, double height) {
  return {{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, true};
}

Region square_at(double x, double y, double side) {
  return fill_region({box(x, y, side, side)}, FillRule::nonzero, canvas);
}

TEST(Region, UnionRunsOutersPositiveAndHolesNegative) {
  const Region frame = unite({square_at(10, 10, 10), square_at(10, 30, 10), square_at(10, 20, 10),
                              square_at(30, 10, 10), square_at(30, 20, 10), square_at(30, 30, 10),
                              square_at(20, 10, 10), square_at(20, 30, 10)});
  ASSERT_EQ(frame.size(), 2u);
  EXPECT_NEAR(area(frame), 800, 1e-9);
  EXPECT_NEAR(std::max(signed_area(frame[0]), signed_area(frame[1])), 900, 1e-9);
  EXPECT_NEAR(std::min(signed_area(frame[0]), signed_area(frame[1])), -100, 1e-9);
  EXPECT_NEAR(area(without_holes(frame)), 900, 1e-9);
}

TEST(Region, OperationsObeyInclusionAndExclusion) {
  const Region p = square_at(10, 10, 30);
  const Region q = square_at(20, 25, 30);
  EXPECT_NEAR(area(intersect(p, q)), 20 * 15, 1e-9);
  EXPECT_NEAR(area(unite(p, q)) + area(intersect(p, q)), area(p) + area(q), 1e-9);
  EXPECT_NEAR(area(subtract(p, q)), area(p) - area(intersect(p, q)), 1e-9);
  EXPECT_TRUE(intersect(p, {}).empty());
  EXPECT_NEAR(area(subtract(p, {})), area(p), 1e-9);
}

TEST(Region, FillRulesDiffer) {
  const std::vector<Polyline> nested = {box(10, 10, 60, 60), box(20, 20, 30, 30)};
  EXPECT_NEAR(area(fill_region(nested, FillRule::nonzero, canvas)), 3600, 1e-9);
  EXPECT_NEAR(area(fill_region(nested, FillRule::even_odd, canvas)), 2700, 1e-9);
}

TEST(Region, FarCoordinatesAreCutWithTheRightWinding) {
  EXPECT_NEAR(area(fill_region({box(-1e9, 50, 2e9, 1e9)}, FillRule::nonzero, canvas)), 5000, 1);
  EXPECT_NEAR(area(fill_region({box(50, 50, 1e9, 1e9)}, FillRule::nonzero, canvas)), 2500, 1e-6);
  EXPECT_TRUE(fill_region({box(200, 200, 50, 50)}, FillRule::nonzero, canvas).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(fill_region({box(nan, 0, 5, 5)}, FillRule::nonzero, canvas).empty());
}

TEST(Region, StrokesHaveTheAreaOfTheirShape) {
  const Polyline line{{{20, 50}, {60, 50}}, false};
  StrokeShape pen;
  pen.width = 6;
  EXPECT_NEAR(area(stroke_region({line}, pen, canvas)), 240, 0.1);
  pen.cap = LineCap::square;
  EXPECT_NEAR(area(stroke_region({line}, pen, canvas)), 276, 0.1);
  pen.cap = LineCap::round;
  EXPECT_NEAR(area(stroke_region({line}, pen, canvas)), 240 + pi * 9, 0.7);
  pen.cap = LineCap::butt;
  const Region rim = stroke_region({box(20, 20, 40, 40)}, pen, canvas);
  EXPECT_NEAR(area(rim), 46 * 46 - 34 * 34, 0.1);
  EXPECT_EQ(rim.size(), 2u);
}

TEST(Region, FarStrokesAreCut) {
  StrokeShape pen;
  pen.width = 10;
  const Polyline line{{{-1e9, 50}, {1e9, 50}}, false};
  EXPECT_NEAR(area(stroke_region({line}, pen, canvas)), 1000, 1);
}

TEST(Region, GrowingIsMinkowski) {
  EXPECT_NEAR(area(grow(square_at(40, 40, 20), 5)), 400 + 80 * 5 + pi * 25, 1.1);
  EXPECT_NEAR(area(grow(square_at(40, 40, 20), -5)), 100, 1e-6);
  EXPECT_TRUE(grow(square_at(40, 40, 20), -11).empty());
}

TEST(Region, PiecesKeepTheirHoles) {
  const Region ring = subtract(square_at(10, 10, 30), square_at(20, 20, 10));
  const std::vector<Region> found = pieces(unite(ring, square_at(60, 60, 10)));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(area(found[0]), 800, 1e-9);
  EXPECT_EQ(found[0].size(), 2u);
  EXPECT_NEAR(area(found[1]), 100, 1e-9);
}

TEST(Region, TidyingDropsSpecksAndPinholes) {
  const Region holed = subtract(square_at(10, 10, 30), square_at(20, 20, 1));
  const Region clean = tidied(unite(holed, square_at(60, 60, 1)), 0.1, 4);
  ASSERT_EQ(clean.size(), 1u);
  EXPECT_NEAR(area(clean), 900, 1e-9);
}

}  // namespace
}  // namespace relievo

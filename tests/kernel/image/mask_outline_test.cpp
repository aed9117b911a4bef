#include <gtest/gtest.h>

#include <cmath>

#include "kernel/geometry/polygon.h"
#include "kernel/image/outlines.h"
#include "support/label_maps.h"

namespace relievo {
namespace {

using namespace testing;

Mask mask_of(const Image16& labels, uint16_t label) {
  Mask mask{0, 0, Image8(labels.width, labels.height, 1)};
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    mask.inside.pixels[i] = labels.pixels[i] == label;
  return mask;
}

TEST(MaskOutline, FillsBackToTheSameMask) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Image16 labels = random_labels(seed);
    const Mask mask = mask_of(labels, 1);
    if (pixel_count(mask) < 100) continue;
    OutlineOptions exact;
    exact.wavelength = 0;
    exact.tolerance = 0;
    exact.min_sides = 0;
    const Mask filled = fill_outline(outline_of(mask, exact), labels.width, labels.height);
    int64_t differ = 0;
    for (int y = 0; y < labels.height; ++y)
      for (int x = 0; x < labels.width; ++x) differ += filled.has(x, y) != mask.has(x, y) ? 1 : 0;
    // The middles of sides cut corners off; only centres of pixels on the outline itself are lost.
    EXPECT_EQ(differ, 0) << seed;
  }
}

/// Makes the mask of the pixels whose centres are in a disc of this radius.
Mask disc_mask(double radius) {
  return mask_of(painted(240, 240, {disc(120.3, 119.8, radius)}), 1);
}

TEST(MaskOutline, LeavesDiscsRound) {
  for (const double radius : {8.0, 12.0, 25.0, 50.0, 100.0}) {
    const Outline outline = outline_of(disc_mask(radius));
    ASSERT_EQ(outline.size(), 1U);
    const double area = M_PI * radius * radius;
    EXPECT_NEAR(signed_area(outline[0]), area, 0.01 * area) << radius;
    for (const Point2 p : outline[0])
      EXPECT_NEAR(distance(p, {120.3, 119.8}), radius, 0.4) << radius;
  }
}

/// Computes the largest difference from the turn of a circle over steps of 3 px, rad.
double worst_turn(const Ring& ring, double radius) {
  const RingMeasure along = measure(ring);
  const auto at = [&](double s) { return point_at(ring, along, s); };
  double worst = 0;
  for (double s = 0; s < along.length; s += 1) {
    const Point2 a = at(s + 3) - at(s);
    const Point2 b = at(s + 6) - at(s + 3);
    worst = std::max(worst, std::abs(std::atan2(cross(a, b), dot(a, b)) - 3 / radius));
  }
  return worst;
}

TEST(MaskOutline, HasNoStairs) {
  OutlineOptions plain;
  plain.wavelength = 0;
  for (const double radius : {25.0, 50.0, 100.0}) {
    const Mask mask = disc_mask(radius);
    EXPECT_GT(worst_turn(outline_of(mask, plain)[0], radius), 0.3) << radius;
    EXPECT_LT(worst_turn(outline_of(mask)[0], radius), 0.03) << radius;
  }
}

/// The tremor of a hand-drawn disc exceeds the usual reach and stays; with a larger reach it goes.
TEST(MaskOutline, WavesOfTheReachGo) {
  const Mask mask =
      mask_of(painted(240, 240, {[](double x, double y) {
                        const double angle = std::atan2(y - 120, x - 120);
                        return std::hypot(x - 120, y - 120) < 80 + 1.5 * std::sin(40 * angle);
                      }}),
              1);
  const auto worst = [&](const OutlineOptions& options) {
    double off = 0;
    const Outline outline = outline_of(mask, options);
    for (const Point2 p : outline[0]) off = std::max(off, std::abs(distance(p, {120, 120}) - 80));
    return off;
  };
  EXPECT_GT(worst({}), 1);
  OutlineOptions rough;
  rough.wavelength *= 2.5;
  rough.reach *= 2.5;
  EXPECT_LT(worst(rough), 0.4);
}

TEST(MaskOutline, CornersStayWithinTheReach) {
  Mask mask = empty_mask(10, 20, 110, 80);
  for (uint8_t& inside : mask.inside.pixels) inside = 1;
  for (const double scale : {1.0, 2.0, 4.0}) {
    OutlineOptions options;
    options.reach *= scale;
    options.wavelength *= scale;
    const Ring ring = outline_of(mask, options)[0];
    const RingMeasure along = measure(ring);
    for (const Point2 corner : {Point2{10, 20}, {110, 20}, {110, 80}, {10, 80}}) {
      const double off = nearest_on_ring(ring, along, corner).distance;
      // The middles of pixel sides cut half a pixel off.
      EXPECT_LT(off, std::sqrt(2) * options.reach + 0.5) << scale;
    }
  }
}

TEST(MaskOutline, TwigsKeepTheirPixels) {
  for (const double width : {2.0, 3.0, 4.0}) {
    const auto is_twig = [width](double x, double y) {
      return std::abs(y - 10 - 0.7 * x) < width && x > 8 && x < 100;
    };
    const Mask twig = mask_of(painted(120, 120, {is_twig}), 1);
    const Mask filled = fill_outline(outline_of(twig), 120, 120);
    int differ = 0;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 120; ++x) differ += filled.has(x, y) != twig.has(x, y) ? 1 : 0;
    EXPECT_LT(differ, 14) << width;
  }
}

TEST(MaskOutline, HolesRunTheOtherWay) {
  Mask mask = mask_of(painted(200, 160, {disc(100, 80, 60), disc(100, 80, 25)}), 1);
  const Outline outline = outline_of(mask);
  ASSERT_EQ(outline.size(), 2U);
  EXPECT_NEAR(signed_area(outline[0]) + signed_area(outline[1]), M_PI * (3600 - 625), 60);
  EXPECT_FALSE(contains(outline, {100, 80}));
  EXPECT_TRUE(contains(outline, {140, 80}));
}

}  // namespace
}  // namespace relievo

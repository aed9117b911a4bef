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
    exact.smoothing = 0;
    exact.tolerance = 0;
    exact.min_sides = 0;
    const Mask filled = fill_outline(outline_of(mask, exact), labels.width, labels.height);
    int64_t differ = 0;
    for (int y = 0; y < labels.height; ++y)
      for (int x = 0; x < labels.width; ++x) differ += filled.has(x, y) != mask.has(x, y) ? 1 : 0;
    // The middles of sides cut corners off; no centre of a pixel is lost but on them.
    EXPECT_EQ(differ, 0) << seed;
  }
}

TEST(MaskOutline, KeepsTheAreaOfADisc) {
  const Image16 labels = painted(200, 200, {disc(100.3, 99.8, 70)});
  const Outline outline = outline_of(mask_of(labels, 1));
  ASSERT_EQ(outline.size(), 1U);
  EXPECT_NEAR(signed_area(outline[0]), M_PI * 70 * 70, 0.01 * M_PI * 70 * 70);
  for (const Point2 p : outline[0]) EXPECT_NEAR(distance(p, {100.3, 99.8}), 70, 0.6);
}

TEST(MaskOutline, HasNoStairs) {
  const Ring ring = outline_of(mask_of(painted(200, 160, {disc(97.3, 80.8, 50)}), 1))[0];
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[(i + 1) % ring.size()] - ring[i];
    const Point2 b = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
    EXPECT_LT(std::abs(std::atan2(cross(a, b), dot(a, b))), 0.4);
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

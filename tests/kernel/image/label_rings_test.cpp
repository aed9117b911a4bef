#include "kernel/image/label_rings.h"

#include <gtest/gtest.h>

#include <map>

#include "kernel/geometry/polygon.h"
#include "kernel/image/connected.h"
#include "kernel/image/fill_outline.h"
#include "kernel/image/mask_outline.h"
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

/// Twice the area that a ring of unit sides encloses, from where their middles lie.
double enclosed_area(const LabelRing& ring) {
  double area = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    // Whole x: a vertical side, which travels down on the right of its label and up on the left.
    const Point2 p = ring.sides[i];
    const Point2 next = ring.sides[(i + 1) % ring.size()];
    const Point2 before = ring.sides[(i + ring.size() - 1) % ring.size()];
    if (p.x != std::floor(p.x)) continue;
    const double down = next.y > p.y || before.y < p.y ? 1 : -1;
    area += down * p.x;
  }
  return area;
}

TEST(LabelRings, EncloseThePixelsOfTheirLabel) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Image16 labels = random_labels(seed);
    std::map<int, double> pixels;
    for (const uint16_t label : labels.pixels) pixels[label] += label > 0 ? 1 : 0;
    std::map<int, double> enclosed;
    for (const LabelRing& ring : trace_label_rings(labels)) {
      EXPECT_EQ(ring.hole, enclosed_area(ring) < 0);
      enclosed[ring.label] += enclosed_area(ring);
    }
    for (const auto& [label, count] : pixels) {
      if (label == 0) continue;
      EXPECT_EQ(enclosed[label], count) << seed;
    }
  }
}

TEST(LabelRings, BothSidesTellOfTheSameBoundary) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::map<std::pair<int, int>, int> sides;
    for (const LabelRing& ring : trace_label_rings(random_labels(seed)))
      for (const uint16_t beyond : ring.beyond) ++sides[{ring.label, beyond}];
    for (const auto& [pair, count] : sides) {
      EXPECT_NE(pair.first, pair.second);
      if (pair.second == 0) continue;
      EXPECT_EQ(sides.at({pair.second, pair.first}), count);
    }
  }
}

TEST(LabelRings, GoRoundEveryHole) {
  const Image16 labels = painted(40, 40, {box(5, 5, 35, 35), disc(14, 14, 4), disc(26, 26, 5)});
  int holes = 0;
  for (const LabelRing& ring : trace_label_rings(labels)) holes += ring.hole ? 1 : 0;
  EXPECT_EQ(holes, 2);
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

TEST(Connected, KeepsThePiecesThatTheSeedReaches) {
  const Image16 labels = painted(60, 20, {box(2, 2, 20, 18)});
  Mask mask = mask_of(labels, 1);
  for (int x = 40; x < 50; ++x) mask.inside.at(x, 10) = 1;
  const Mask seed{5, 5, Image8(1, 1, 1, 1)};
  EXPECT_EQ(pixel_count(connected_to(mask, seed)), 18 * 16);
}

}  // namespace
}  // namespace relievo

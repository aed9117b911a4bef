#include <gtest/gtest.h>

#include <map>

#include "kernel/image/outlines.h"
#include "support/label_maps.h"

namespace relievo {
namespace {

using namespace testing;

/// Computes twice the area that a ring of unit sides encloses from the middles of the sides.
double enclosed_area(const LabelRing& ring) {
  double area = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    // An integer x is a vertical side, which runs down on the right of its label and up on the
    // left.
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

}  // namespace
}  // namespace relievo

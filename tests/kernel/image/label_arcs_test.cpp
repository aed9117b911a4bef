#include "kernel/image/label_arcs.h"

#include <gtest/gtest.h>

#include <random>

namespace relievo {
namespace {

Image16 random_labels(int width, int height, uint32_t label_count, uint32_t seed) {
  std::mt19937 random(seed);
  Image16 labels(width, height, 1);
  for (uint16_t& label : labels.pixels) label = static_cast<uint16_t>(random() % label_count);
  return labels;
}

/// Twice the area to the right of a ring of arcs.
int64_t twice_area(const std::vector<LabelArc>& arcs, const std::vector<ArcUse>& ring) {
  int64_t sum = 0;
  for (const ArcUse& use : ring) {
    const auto& corners = arcs[use.arc].corners;
    for (size_t i = 0; i + 1 < corners.size(); ++i) {
      const PixelCorner a = corners[i];
      const PixelCorner b = corners[i + 1];
      const int64_t cross = int64_t{a.x} * b.y - int64_t{a.y} * b.x;
      sum += use.forward ? cross : -cross;
    }
  }
  return sum;
}

TEST(LabelArcs, RingsBoundExactlyThePixelsOfTheirLabel) {
  for (uint32_t seed = 0; seed < 60; ++seed) {
    const Image16 labels = random_labels(1 + static_cast<int>(seed % 17), 13, 2 + seed % 3, seed);
    const std::vector<LabelArc> arcs = trace_label_arcs(labels);
    const auto rings = label_rings(arcs);
    std::vector<int64_t> pixels(rings.size(), 0);
    for (const uint16_t label : labels.pixels)
      if (label != 0) ++pixels[label];
    for (size_t label = 1; label < rings.size(); ++label) {
      int64_t area = 0;
      for (const auto& ring : rings[label]) area += twice_area(arcs, ring);
      EXPECT_EQ(area, 2 * pixels[label]) << seed;
    }
  }
}

TEST(LabelArcs, EveryBoundarySideIsTracedOnce) {
  const Image16 labels = random_labels(19, 11, 3, 5);
  int64_t sides = 0;
  const auto label = [&](int x, int y) {
    return x < 0 || y < 0 || x >= 19 || y >= 11 ? 0 : labels.at(x, y);
  };
  for (int y = 0; y <= 11; ++y)
    for (int x = 0; x <= 19; ++x)
      sides += (label(x, y) != label(x - 1, y) ? 1 : 0) + (label(x, y) != label(x, y - 1) ? 1 : 0);
  int64_t traced = 0;
  for (const LabelArc& arc : trace_label_arcs(labels)) {
    traced += static_cast<int64_t>(arc.corners.size()) - 1;
    EXPECT_NE(arc.left, arc.right);
    for (size_t i = 0; i + 1 < arc.corners.size(); ++i)
      EXPECT_EQ(std::abs(arc.corners[i + 1].x - arc.corners[i].x) +
                    std::abs(arc.corners[i + 1].y - arc.corners[i].y),
                1);
  }
  EXPECT_EQ(traced, sides);
}

TEST(LabelArcs, PixelsThatTouchAtACornerArePartedThere) {
  Image16 labels(2, 2, 1);
  labels.at(0, 0) = labels.at(1, 1) = 1;
  const auto rings = label_rings(trace_label_arcs(labels));
  ASSERT_EQ(rings.size(), 2U);
  EXPECT_EQ(rings[1].size(), 2U);
}

TEST(LabelArcs, NeighboursShareTheirArcs) {
  Image16 labels(8, 4, 1, 1);
  for (int y = 0; y < 4; ++y)
    for (int x = 4; x < 8; ++x) labels.at(x, y) = 2;
  const std::vector<LabelArc> arcs = trace_label_arcs(labels);
  EXPECT_EQ(arcs.size(), 3U);
  const auto rings = label_rings(arcs);
  ASSERT_EQ(rings[1].size(), 1U);
  ASSERT_EQ(rings[2].size(), 1U);
  EXPECT_EQ(rings[1][0].size(), 2U);
  EXPECT_EQ(rings[2][0].size(), 2U);
}

}  // namespace
}  // namespace relievo

#include "kernel/image/ring_changes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernel/geometry/polyline.h"

namespace relievo {
namespace {

/// Makes labels with 1 above 2 on the left and 3 on the right of a column, and 0 around.
Image16 three_labels(int column) {
  Image16 labels(80, 80, 1);
  for (int y = 10; y < 70; ++y)
    for (int x = 10; x < 70; ++x)
      labels.at(x, y) = static_cast<uint16_t>(y < 40 ? 1 : x < column ? 2 : 3);
  return labels;
}

TEST(RingChanges, TellWhoseContourGoesStraightOn) {
  for (const int column : {25, 40, 52})
    for (const LabelRing& ring : trace_label_rings(three_labels(column))) {
      int inside = 0;
      for (const RingChange& change : ring_changes(ring, 3, 12)) {
        if (change.before == 0 || change.after == 0) continue;
        ++inside;
        const double turn = std::abs(turn_between(change.in, change.out));
        EXPECT_NEAR(turn, ring.label == 1 ? 0 : std::numbers::pi / 2, 1e-12);
        EXPECT_DOUBLE_EQ(norm(change.in), 9);
        EXPECT_DOUBLE_EQ(norm(change.out), 8);
        EXPECT_EQ(change.run_before, 12U);
        EXPECT_EQ(ring.beyond[change.at], change.after);
      }
      EXPECT_EQ(inside, 1) << ring.label;
    }
}

TEST(RingChanges, ShortRunsHaveNoDirection) {
  for (const LabelRing& ring : trace_label_rings(three_labels(12)))
    for (const RingChange& change : ring_changes(ring, 3, 12))
      if (change.run_after < 5) {
        EXPECT_EQ(change.out, Point2{});
      }
  EXPECT_TRUE(ring_changes(trace_label_rings(three_labels(80))[1], 3, 90).size() == 2);
}

}  // namespace
}  // namespace relievo

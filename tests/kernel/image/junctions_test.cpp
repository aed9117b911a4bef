#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernel/geometry/polyline.h"
#include "kernel/image/outlines.h"

namespace relievo {
namespace {

/// Label 1 lies above 2 on the left and 3 on the right of a column; all around is 0.
Image16 three_labels(int column) {
  Image16 labels(80, 80, 1);
  for (int y = 10; y < 70; ++y)
    for (int x = 10; x < 70; ++x)
      labels.at(x, y) = static_cast<uint16_t>(y < 40 ? 1 : x < column ? 2 : 3);
  return labels;
}

TEST(Junctions, LabelsWhoseContourGoesStraightOnHideTheOthers) {
  for (const int column : {25, 40, 52})
    for (const LabelRing& ring : trace_label_rings(three_labels(column))) {
      int inside = 0;
      for (const Junction& junction : find_junctions(ring)) {
        if (junction.before == 0 || junction.after == 0) continue;
        ++inside;
        const double turn = std::abs(turn_between(junction.in, junction.out));
        EXPECT_NEAR(turn, ring.label == 1 ? 0 : std::numbers::pi / 2, 1e-12);
        EXPECT_DOUBLE_EQ(norm(junction.in), 11);
        EXPECT_DOUBLE_EQ(norm(junction.out), 10);
        EXPECT_NEAR(t_junction_confidence(junction), ring.label == 1 ? 1 : 0, 0.01);
        EXPECT_EQ(ring.beyond[junction.at], junction.after);
      }
      EXPECT_EQ(inside, 1) << ring.label;
    }
}

TEST(Junctions, ShortSidesHaveNoDirection) {
  int found = 0;
  for (const LabelRing& ring : trace_label_rings(three_labels(12)))
    for (const Junction& junction : find_junctions(ring))
      if (ring.label == 1 && junction.after == 2) {
        ++found;
        EXPECT_EQ(junction.out, Point2{});
        EXPECT_EQ(t_junction_confidence(junction), 0);
      }
  EXPECT_EQ(found, 1);
  EXPECT_EQ(find_junctions(trace_label_rings(three_labels(80))[1]).size(), 2U);
}

}  // namespace
}  // namespace relievo

#include "relief/drawing/label_outlines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "kernel/geometry/ring_measure.h"
#include "relief/drawing/segment_drawing.h"
#include "support/ink_drawing.h"

namespace relievo {
namespace {

Image16 disc_labels(Point2 centre, double radius) {
  Image16 labels(200, 160, 1);
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 200; ++x)
      if (distance({x + 0.5, y + 0.5}, centre) < radius) labels.at(x, y) = 1;
  return labels;
}

TEST(LabelOutlines, StairsBecomeASmoothCircle) {
  const Point2 centre{97.3, 80.8};
  const auto outlines = label_outlines(disc_labels(centre, 50));
  ASSERT_EQ(outlines.size(), 2U);
  EXPECT_TRUE(outlines[0].empty());
  ASSERT_EQ(outlines[1].size(), 1U);
  const Ring& ring = outlines[1][0];
  for (const Point2 p : ring) EXPECT_NEAR(distance(p, centre), 50, 0.5);
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[(i + 1) % ring.size()] - ring[i];
    const Point2 b = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
    EXPECT_LT(std::abs(std::atan2(cross(a, b), dot(a, b))), 0.35);
  }
  EXPECT_NEAR(perimeter(ring), 2 * 3.14159265 * 50, 3);
  EXPECT_GT(signed_area(ring), 0);
}

TEST(LabelOutlines, RunAlongTheMiddleOfLines) {
  const Point2 centre{120.4, 118.7};
  for (const double width : {3.0, 5.0, 7.0}) {
    const Result<Segmentation> s =
        segment_drawing(InkDrawing(240, 240).circle(centre, 80, width).drawing());
    ASSERT_TRUE(s.ok());
    const auto outlines = label_outlines(s->labels, s->ink, width);
    ASSERT_EQ(outlines.size(), 2U);
    ASSERT_EQ(outlines[1].size(), 1U);
    for (const Point2 p : outlines[1][0]) EXPECT_NEAR(distance(p, centre), 80, 0.35) << width;
  }
}

TEST(LabelOutlines, NeighboursHaveTheSamePoints) {
  Image16 labels(120, 90, 1);
  for (int y = 10; y < 80; ++y)
    for (int x = 10; x < 110; ++x)
      labels.at(x, y) = static_cast<uint16_t>(x + 15 * std::sin(y * 0.1) < 60 ? 1 : 2);
  const auto outlines = label_outlines(labels);
  ASSERT_EQ(outlines.size(), 3U);
  std::set<std::pair<double, double>> first;
  for (const Point2 p : outlines[1][0]) first.insert({p.x, p.y});
  int shared = 0;
  for (const Point2 p : outlines[2][0]) {
    const bool inner = p.y > 12 && p.y < 78 && p.x > 30 && p.x < 90;
    if (!inner) continue;
    EXPECT_EQ(first.count({p.x, p.y}), 1U);
    ++shared;
  }
  EXPECT_GT(shared, 10);
  const double sum = signed_area(outlines[1][0]) + signed_area(outlines[2][0]);
  EXPECT_NEAR(sum, 70 * 100, 40);
}

TEST(LabelOutlines, HolesRunTheOtherWay) {
  Image16 labels = disc_labels({100, 80}, 60);
  const Image16 hole = disc_labels({100, 80}, 25);
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    if (hole.pixels[i] != 0) labels.pixels[i] = 0;
  const auto outlines = label_outlines(labels);
  ASSERT_EQ(outlines[1].size(), 2U);
  EXPECT_NEAR(signed_area(outlines[1][0]) + signed_area(outlines[1][1]), 3.14159265 * (3600 - 625),
              60);
  EXPECT_FALSE(contains(outlines[1], {100, 80}));
  EXPECT_TRUE(contains(outlines[1], {140, 80}));
}

TEST(LabelOutlines, LabelsAtTheEdgeAreClosedAlongIt) {
  const Image16 labels(40, 30, 1, 1);
  const auto outlines = label_outlines(labels);
  ASSERT_EQ(outlines[1].size(), 1U);
  EXPECT_NEAR(signed_area(outlines[1][0]), 40 * 30, 12);
}

}  // namespace
}  // namespace relievo

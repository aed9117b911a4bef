#include "understanding/areas/see_through.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/ink_drawing.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

constexpr Point2 trunk_middle = {250, 250};
constexpr double trunk_radius = 120;  ///< px
constexpr double root = 70;           ///< the middle of the limb's inner end, px from the trunk's
constexpr double limb_end = 210;

Point2 towards(double turn, double along, double aside = 0) {
  const Point2 d{std::cos(2 * std::numbers::pi * turn), std::sin(2 * std::numbers::pi * turn)};
  return trunk_middle + along * d + aside * Point2{-d.y, d.x};
}

/// A round body and a limb with round ends; both outlines are drawn whole.
InkDrawing drawn_through(double turn, double half_width, double pen) {
  InkDrawing ink(500, 500);
  ink.circle(trunk_middle, trunk_radius, pen);
  ink.arc(towards(turn, root), half_width, turn + 0.25, turn + 0.75, pen);
  ink.arc(towards(turn, limb_end), half_width, turn - 0.25, turn + 0.25, pen);
  for (const double aside : {-half_width, half_width})
    ink.line(towards(turn, root, aside), towards(turn, limb_end, aside), pen);
  return ink;
}

uint16_t seen_at(const Segmentation& s, Point2 p) {
  return s.labels.at(static_cast<int>(p.x), static_cast<int>(p.y));
}

TEST(SeeThrough, ALimbDrawnThroughTheBodyIsOnePart) {
  for (const double pen : {3.0, 5.0, 8.0})
    for (const double half_width : {18.0, 26.0})
      for (int k = 0; k < 7; ++k) {
        const double turn = k / 7.0 + 0.03;
        const auto s = segment_drawing(drawn_through(turn, half_width, pen).drawing());
        ASSERT_TRUE(s.ok()) << to_string(s.error());
        EXPECT_EQ(s->parts.size(), 2U) << pen << ", " << half_width << ", " << k;
        EXPECT_EQ(seen_at(*s, towards(turn, root)), seen_at(*s, towards(turn, limb_end)));
        EXPECT_NE(seen_at(*s, trunk_middle), seen_at(*s, towards(turn, limb_end)));
      }
}

TEST(SeeThrough, AnOverlapOfTheSameColourBelongsToTheSmallerPart) {
  InkDrawing ink(500, 500);
  ink.circle({250, 320}, 130).circle({250, 150}, 80);
  const auto s = segment_drawing(ink.drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 2U);
  EXPECT_EQ(seen_at(*s, {250, 210}), seen_at(*s, {250, 120}));
}

TEST(SeeThrough, AnOverlapOfAnotherColourIsAPart) {
  InkDrawing ink(500, 500);
  ink.disc({250, 320}, 130, 150, 180, 240).disc({250, 150}, 80, 240, 220, 150);
  Drawing drawing = ink.circle({250, 320}, 130).circle({250, 150}, 80).drawing();
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 500; ++x) {
      const Point2 p{x + 0.5, y + 0.5};
      if (distance(p, {250, 320}) < 127 && distance(p, {250, 150}) < 77)
        drawing.rgba.at(x, y, 0) = 120;
    }
  const auto s = segment_drawing(drawing);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 3U);
}

/// The labels of rectangles painted one over the other.
Image16 painted(const std::vector<Box2>& boxes) {
  Image16 labels(120, 120, 1);
  for (size_t k = 0; k < boxes.size(); ++k)
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 120; ++x)
        if (x >= boxes[k].min.x && x < boxes[k].max.x && y >= boxes[k].min.y && y < boxes[k].max.y)
          labels.at(x, y) = static_cast<uint16_t>(k + 1);
  return labels;
}

TEST(SeeThrough, OutlinesThatEndOrTurnDoNotCross) {
  const Box2 body{{20, 20}, {80, 80}};
  const Box2 limb{{50, 50}, {110, 110}};
  const auto crossing = find_shared_areas(painted({body, limb, {{50, 50}, {80, 80}}}), 2);
  ASSERT_EQ(crossing.size(), 1U);
  EXPECT_EQ(crossing[0].shared, 3);
  // A patch on the corner of one of them, and one between two that do not overlap.
  EXPECT_TRUE(find_shared_areas(painted({body, limb}), 2).empty());
  EXPECT_TRUE(find_shared_areas(painted({body, {{30, 30}, {50, 50}}}), 2).empty());
  EXPECT_TRUE(
      find_shared_areas(painted({body, {{80, 20}, {110, 80}}, {{60, 35}, {95, 65}}}), 2).empty());
}

}  // namespace
}  // namespace relievo::understanding

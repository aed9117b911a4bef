#include "understanding/lines/line_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/ink_drawing.h"
#include "understanding/areas/find_basins.h"
#include "understanding/labels/segment_drawing.h"
#include "understanding/paper/lay_on_white.h"
#include "understanding/perception/built_in_network.h"

namespace relievo::understanding {
namespace {

constexpr Point2 middle = {250, 250};
constexpr double body_radius = 120;  ///< px
constexpr double shoulder = 50;      ///< px from the middle to the ends of the arm's lines inside
constexpr double hand = 225;         ///< px from the middle to the closed end outside

/// A round body, and across its outline an arm that is open at the shoulder.
struct Arm {
  double turn;        ///< direction of the arm, turns
  double half_width;  ///< px
  double pen = 4;

  Point2 along() const {
    return {std::cos(2 * std::numbers::pi * turn), std::sin(2 * std::numbers::pi * turn)};
  }
  /// Returns a point of the arm, px from the middle and px to the right of its middle line.
  Point2 at(double distance, double aside) const {
    const Point2 d = along();
    return middle + distance * d + aside * Point2{-d.y, d.x};
  }
  InkDrawing ink() const {
    const double hidden = std::asin(half_width / body_radius) / (2 * std::numbers::pi);
    InkDrawing ink(500, 500);
    ink.arc(middle, body_radius, turn + hidden, turn + 1 - hidden, pen);
    ink.line(at(shoulder, -half_width), at(hand, -half_width), pen);
    ink.line(at(shoulder, half_width), at(hand, half_width), pen);
    return ink.line(at(hand, -half_width), at(hand, half_width), pen);
  }
};

std::vector<LineGap> roots_of(const InkDrawing& ink) {
  const LineMap map = find_lines(lay_on_white(ink.drawing().rgba));
  return find_open_roots(find_loose_ends(map), map);
}

TEST(OpenRoots, AnArmThatIsOpenAtTheShoulderIsAPart) {
  int one_part = 0;
  for (const double pen : {3.0, 5.0, 8.0})
    for (const double half_width : {15.0, 25.0})
      for (int k = 0; k < 7; ++k) {
        const Arm arm{k / 7.0 + 0.03, half_width, pen};
        const Result<Segmentation> s = segment_drawing(arm.ink().drawing());
        ASSERT_TRUE(s.ok()) << to_string(s.error());
        const auto label = [&](Point2 p) {
          return s->labels.at(static_cast<int>(p.x), static_cast<int>(p.y));
        };
        if (s->parts.size() == 1) {
          ++one_part;
          continue;
        }
        EXPECT_EQ(s->parts.size(), 2U) << pen << ", " << half_width << ", " << k;
        EXPECT_EQ(label(arm.at(190, 0)), label(arm.at(shoulder + 12, 0)));
        EXPECT_NE(label(arm.at(190, 0)), label(arm.at(shoulder - 12, 0)));
        EXPECT_EQ(label(arm.at(-60, 0)), label(arm.at(shoulder - 12, 0)));
        // The closed gap is reported, so that a user can object.
        ASSERT_EQ(s->bridges.size(), 1U);
        for (const Point2 p : s->bridges[0].points) {
          EXPECT_NEAR(dot(p - middle, arm.along()), shoulder, pen + 3);
          EXPECT_LT(std::abs(cross(p - middle, arm.along())), half_width + 2);
        }
      }
  EXPECT_LE(one_part, 8) << "of 42";
}

TEST(OpenRoots, LieBetweenTheEndsOfTheLines) {
  const Arm arm{0.1, 20};
  const std::vector<LineGap> roots = roots_of(arm.ink());
  ASSERT_EQ(roots.size(), 1U);
  const auto [a, b] = roots[0];
  EXPECT_LT(std::min(distance(a, arm.at(shoulder, 20)), distance(b, arm.at(shoulder, 20))), 4);
  EXPECT_LT(std::min(distance(a, arm.at(shoulder, -20)), distance(b, arm.at(shoulder, -20))), 4);
}

TEST(OpenRoots, StrokesOverrule) {
  const Arm arm{0.2, 20};
  const Point2 from = arm.at(0, 0);
  const Point2 to = arm.at(190, 0);
  const Result<Segmentation> s =
      segment_drawing(arm.ink().drawing(), {{"all"}, {{ScribbleKind::hard, 0, {from, to}, 5}}});
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->parts.size(), 1U);
}

TEST(OpenRoots, HatchingHidesNothing) {
  InkDrawing ink(500, 500);
  ink.circle(middle, body_radius);
  for (const double x : {210.0, 250.0, 290.0})
    ink.line({x, middle.y - std::sqrt(body_radius * body_radius - (x - 250) * (x - 250))},
             {x, 230});
  EXPECT_TRUE(roots_of(ink).empty());
}

TEST(OpenRoots, WhiskersHideNothing) {
  InkDrawing ink(500, 500);
  ink.circle(middle, body_radius);
  for (const double y : {220.0, 250.0, 280.0}) ink.line({310, y}, {440, y});
  EXPECT_TRUE(roots_of(ink).empty());
}

TEST(OpenRoots, ALineBetweenTheEndsPartsThem) {
  const Arm arm{0.1, 25};
  InkDrawing ink = arm.ink();
  EXPECT_EQ(roots_of(ink).size(), 1U);
  ink.line(arm.at(shoulder - 30, 0), arm.at(shoulder + 30, 0));
  EXPECT_TRUE(roots_of(ink).empty());
}

int label_of_point(const Segmentation& segmentation, Point2 p) {
  return segmentation.labels.at(static_cast<int>(p.x), static_cast<int>(p.y));
}

TEST(BrokenOutlines, ACircleOfArcsIsAPart) {
  for (const int arcs : {2, 3, 4})
    for (int k = 0; k < 5; ++k) {
      InkDrawing ink(500, 500);
      for (int a = 0; a < arcs; ++a) {
        const double from = 0.03 + k / 37.0 + static_cast<double>(a) / arcs;
        ink.arc(middle, body_radius, from, from + 1.0 / arcs - 0.1);
      }
      const Result<Segmentation> s = segment_drawing(ink.drawing());
      ASSERT_TRUE(s.ok()) << to_string(s.error());
      EXPECT_EQ(s->parts.size(), 1U) << arcs << ", " << k;
      for (const Point2 p : {middle, middle + Point2{100, 0}, middle + Point2{-50, 80}})
        EXPECT_NE(label_of_point(*s, p), 0) << arcs << ", " << k;
    }
}

TEST(BrokenOutlines, AnEndContinuesToTheLineOrDarkShapeAhead) {
  for (int k = 0; k < 10; ++k) {
    const Arm arm{k % 5 / 5.0 + 0.02, 25};
    InkDrawing ink(500, 500);
    if (k < 5)
      ink.circle(middle, 95);
    else
      ink.disc(middle, 95, 20, 20, 20);
    for (const double aside : {-25.0, 25.0}) ink.line(arm.at(120, aside), arm.at(hand, aside));
    ink.line(arm.at(hand, -25), arm.at(hand, 25));
    const Result<Segmentation> s = segment_drawing(ink.drawing());
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), 2U) << k;
    EXPECT_NE(label_of_point(*s, arm.at(180, 0)), 0) << k;
    EXPECT_NE(label_of_point(*s, arm.at(180, 0)), label_of_point(*s, middle)) << k;
  }
}

TEST(BrokenOutlines, AStubContinuesToALongLine) {
  InkDrawing ink(500, 500);
  ink.circle({90, 260}, 60).line({134, 220}, {181, 220});
  ink.line({246, 220}, {440, 220}).line({440, 220}, {440, 310}).line({440, 310}, {123, 310});
  const Result<Segmentation> s = segment_drawing(ink.drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_NE(label_of_point(*s, {300, 265}), 0);
  EXPECT_NE(label_of_point(*s, {300, 265}), label_of_point(*s, {90, 260}));
}

TEST(BrokenOutlines, StrokesThatFaceEachOtherInsideDivideNothing) {
  InkDrawing ink(500, 500);
  ink.circle(middle, 150);
  ink.line({125, 250}, {220, 250});
  ink.line({280, 250}, {375, 250});
  const Result<Segmentation> s = segment_drawing(ink.drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 1U);
}

TEST(BrokenOutlines, AreClosedAroundWhiteAmongPaint) {
  for (int k = 0; k < 5; ++k) {
    InkDrawing ink(500, 500);
    ink.disc({120, 120}, 50, 200, 120, 40).disc({380, 120}, 50, 200, 120, 40);
    for (int a = 0; a < 3; ++a) {
      const double from = 0.03 + k / 37.0 + a / 3.0;
      ink.arc(middle, body_radius, from, from + 0.26);
    }
    const Result<Segmentation> s = segment_drawing(ink.drawing());
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    for (const Point2 p : {middle, middle + Point2{100, 0}, middle + Point2{-50, 80}})
      EXPECT_NE(label_of_point(*s, p), 0) << k;
  }
}

TEST(BrokenOutlines, AreNotWherePaintEnds) {
  // Two strokes in line with each other: on white, and along two limbs.
  for (const bool limbs : {false, true}) {
    InkDrawing ink(500, 500);
    ink.disc({250, 420}, 60, 200, 120, 40);
    for (double x = 90; limbs && x < 220; x += 5)
      ink.disc({x, 215}, 15, 200, 120, 40).disc({500 - x, 215}, 15, 200, 120, 40);
    ink.line({80, 200}, {230, 200}).line({270, 200}, {420, 200});
    const Image8 rgb = lay_on_white(ink.drawing().rgba);
    const LineMap map = find_lines(rgb, true);
    ASSERT_TRUE(map.painted);
    EXPECT_EQ(find_broken_outlines(find_loose_ends(map), map, rgb).empty(), limbs);
  }
}

TEST(BrokenOutlines, AStickFigureGetsNoWings) {
  InkDrawing ink(500, 500);
  ink.circle({250, 130}, 50);
  ink.line({250, 180}, {250, 340});
  for (const double way : {-1.0, 1.0}) {
    ink.line({250, 220}, {250 + 90 * way, 230});
    ink.line({250 + 90 * way, 230}, {250 + 90 * way, 120});
    ink.line({250, 340}, {250 + 50 * way, 450});
  }
  const Result<Segmentation> s = segment_drawing(ink.drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  for (const double way : {-1.0, 1.0}) {
    EXPECT_EQ(label_of_point(*s, {250 + 12 * way, 430}), 0);
  }
}

}  // namespace
}  // namespace relievo::understanding

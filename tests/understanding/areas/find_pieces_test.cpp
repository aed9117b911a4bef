#include "understanding/areas/find_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/ink_drawing.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

using Pieces = std::vector<std::pair<uint16_t, uint16_t>>;

const Box2 upright_body = {{70, 20}, {130, 280}};

/// The labels of a body, 1, and of two areas to its left and right, 2 and 3.
Image16 beside_body(const Box2& left, const Box2& right) {
  Image16 labels(200, 300, 1);
  const std::array<Box2, 3> boxes = {upright_body, left, right};
  for (size_t k = 0; k < boxes.size(); ++k)
    for (int y = static_cast<int>(boxes[k].min.y); y < boxes[k].max.y; ++y)
      for (int x = static_cast<int>(boxes[k].min.x); x < boxes[k].max.x; ++x)
        labels.at(x, y) = static_cast<uint16_t>(k + 1);
  return labels;
}

TEST(FindPieces, ACapeIsSeenOnBothSidesOfABody) {
  for (const double top : {60.0, 150.0, 200.0})
    EXPECT_EQ(find_pieces(beside_body({{50, top}, {70, top + 60}}, {{130, top}, {150, top + 60}})),
              (Pieces{{2, 3}}))
        << top;
}

TEST(FindPieces, AreasThatDoNotContinueBehindTheBodyStayApart) {
  const Box2 left = {{50, 60}, {70, 120}};
  EXPECT_TRUE(find_pieces(beside_body(left, {{130, 160}, {150, 220}})).empty());
  // The body does not hide areas that end before it.
  EXPECT_TRUE(find_pieces(beside_body({{45, 60}, {65, 120}}, {{135, 60}, {155, 120}})).empty());
}

/// Like beside_body, but the body is stout in the middle: its contour bends where it hides.
Image16 beside_stout_body(double slope) {
  Image16 labels = beside_body({{56, 120}, {70, 180}}, {{130, 120}, {144, 180}});
  for (int y = 20; y < 280; ++y) {
    const double width = std::max(12.0, 30 - slope * std::max({0.0, 120.5 - y, y - 179.5}));
    for (int x = 70; x < 130; ++x)
      if (std::abs(x - 99.5) >= width) labels.at(x, y) = 0;
  }
  return labels;
}

TEST(FindPieces, AnOccludersContourMayBend) {
  for (const double slope : {0.0, 0.5, 1.0})
    EXPECT_EQ(find_pieces(beside_stout_body(slope)), (Pieces{{2, 3}})) << slope;
}

TEST(FindPieces, ArmsThatAreSpreadStayTwo) {
  EXPECT_TRUE(find_pieces(beside_body({{5, 60}, {70, 90}}, {{130, 60}, {195, 90}})).empty());
}

TEST(FindPieces, ADrawnCapeIsOnePart) {
  InkDrawing ink(400, 600);
  const auto box = [&ink](Point2 a, Point2 b) {
    ink.line(a, {b.x, a.y}).line({b.x, a.y}, b).line(b, {a.x, b.y}).line({a.x, b.y}, a);
  };
  box({140, 40}, {260, 560});
  box({100, 300}, {140, 420});
  box({260, 300}, {300, 420});
  const auto s = segment_drawing(ink.drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 2U);
  EXPECT_NE(s->labels.at(120, 360), s->labels.at(200, 360));
  EXPECT_EQ(s->labels.at(120, 360), s->labels.at(280, 360));
}

TEST(FindPieces, AStrokeOnOnePieceTakesBoth) {
  InkDrawing ink(400, 600);
  ink.line({140, 40}, {260, 40}).line({140, 560}, {260, 560});
  ink.line({140, 40}, {140, 560}).line({260, 40}, {260, 560});
  for (const double x : {100.0, 300.0}) {
    const double near = x < 200 ? 140 : 260;
    ink.line({near, 300}, {x, 300}).line({x, 300}, {x, 420}).line({x, 420}, {near, 420});
  }
  Scribbles scribbles;
  scribbles.parts = {"cape"};
  scribbles.strokes = {{ScribbleKind::hard, 0, {{120, 340}, {120, 380}}, 8}};
  const auto s = segment_drawing(ink.drawing(), scribbles);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->labels.at(120, 360), 1);
  EXPECT_EQ(s->labels.at(280, 360), 1);
}

}  // namespace
}  // namespace relievo::understanding

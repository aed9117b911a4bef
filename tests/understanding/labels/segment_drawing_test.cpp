#include "understanding/labels/segment_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "support/ink_drawing.h"
#include "support/random_image.h"

namespace relievo::understanding {
namespace {

/// A head on a body.
InkDrawing snowman() {
  InkDrawing ink(300, 400);
  ink.arc({150, 120}, 70, 0.36, 1.14).arc({150, 260}, 100, 0, 1);
  return ink;
}

uint16_t label_at(const Segmentation& s, int x, int y) { return s.labels.at(x, y); }

TEST(SegmentDrawing, ClosedLinesNeedNoScribbles) {
  const Result<Segmentation> s = segment_drawing(snowman().drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 2U);
  EXPECT_EQ(label_at(*s, 5, 5), 0);
  const uint16_t head = label_at(*s, 150, 140);
  const uint16_t body = label_at(*s, 150, 260);
  EXPECT_NE(head, 0);
  EXPECT_NE(body, 0);
  EXPECT_NE(head, body);
  EXPECT_TRUE(s->bridges.empty());
}

TEST(SegmentDrawing, InkDividesDarkPaint) {
  // A dark disc and a light one, each outlined and divided by a line of the same ink.
  for (const int paint : {76, 90, 120, 220}) {
    Drawing drawing{Image8(500, 260, 4, 255)};
    for (int y = 0; y < 260; ++y)
      for (int x = 0; x < 500; ++x) {
        const bool left = x < 250;
        const double r = distance({x + 0.5, y + 0.5}, {left ? 130.0 : 370.0, 130.0});
        if (r > 102) continue;
        const bool ink = r > 98 || std::abs(x - (left ? 130 : 370)) < 2;
        for (int c = 0; c < 3; ++c)
          drawing.rgba.at(x, y, c) = static_cast<uint8_t>(ink ? 32 : left ? paint : 230);
      }
    const Result<Segmentation> s = segment_drawing(drawing);
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), 4U) << paint;
    EXPECT_NE(label_at(*s, 90, 130), label_at(*s, 170, 130)) << paint;
  }
}

TEST(SegmentDrawing, WhiskersBelongToTheHeadAndNotToTheBackground) {
  // A whisker drawn as a thin closed shape reaches from the cheek over the head's outline. Such a
  // narrow gap between strokes is no part.
  for (const double end : {240.0, 270.0}) {
    InkDrawing ink(300, 240);
    ink.arc({150, 120}, 80, 0.008, 0.992);
    ink.line({200, 116}, {end, 116}).line({200, 124}, {end, 124});
    ink.line({200, 116}, {200, 124}).line({end, 116}, {end, 124});
    const Result<Segmentation> s = segment_drawing(ink.drawing());
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), 1U) << end;
    EXPECT_EQ(label_at(*s, 215, 120), label_at(*s, 150, 120)) << end;
    EXPECT_EQ(label_at(*s, 290, 120), 0) << end;
  }
}

TEST(SegmentDrawing, LabelsMeetInTheMiddleOfLinesAndHoldTheInkOfTheOutline) {
  const Result<Segmentation> s =
      segment_drawing(InkDrawing(200, 200).circle({100, 100}, 60, 8).drawing());
  ASSERT_TRUE(s.ok());
  EXPECT_NEAR(static_cast<double>(s->parts[0].area), 3.14159 * 64 * 64, 3.14159 * 128 * 0.7);

  const Result<Segmentation> halves = segment_drawing(
      InkDrawing(200, 200).circle({100, 100}, 60, 6).line({40, 100}, {160, 100}, 6).drawing());
  ASSERT_TRUE(halves.ok());
  ASSERT_EQ(halves->parts.size(), 2U);
  EXPECT_NEAR(static_cast<double>(halves->parts[0].area),
              static_cast<double>(halves->parts[1].area), 130);
}

TEST(SegmentDrawing, AreasAndBoxesAreThoseOfTheLabels) {
  const Result<Segmentation> s = segment_drawing(snowman().drawing());
  ASSERT_TRUE(s.ok());
  for (size_t k = 0; k < s->parts.size(); ++k) {
    int64_t area = 0;
    Box2 box;
    for (int y = 0; y < s->labels.height; ++y)
      for (int x = 0; x < s->labels.width; ++x) {
        if (s->labels.at(x, y) != k + 1) continue;
        ++area;
        box.add(Point2{x * 1.0, y * 1.0});
        box.add(Point2{x + 1.0, y + 1.0});
      }
    EXPECT_EQ(s->parts[k].area, area);
    EXPECT_EQ(s->parts[k].box.min, box.min);
    EXPECT_EQ(s->parts[k].box.max, box.max);
  }
}

TEST(SegmentDrawing, BackgroundAndLightDoNotChangeTheParts) {
  const Result<Segmentation> plain = segment_drawing(snowman().drawing());
  const Result<Segmentation> transparent = segment_drawing(snowman().on_transparent_ground());
  const Result<Segmentation> photo = segment_drawing(snowman().photographed());
  ASSERT_TRUE(plain.ok() && transparent.ok() && photo.ok());
  for (const Result<Segmentation>* other : {&transparent, &photo}) {
    ASSERT_EQ((*other)->parts.size(), plain->parts.size());
    int64_t different = 0;
    for (size_t i = 0; i < plain->labels.pixels.size(); ++i)
      different += plain->labels.pixels[i] != (*other)->labels.pixels[i] ? 1 : 0;
    EXPECT_LT(different, 1200) << "a pixel along all lines at most";
  }
}

TEST(SegmentDrawing, WhiteLinesOnATransparentBackgroundCount) {
  Drawing drawing = snowman().on_transparent_ground();
  for (size_t i = 0; i < drawing.rgba.pixels.size(); ++i)
    if (i % 4 != 3) drawing.rgba.pixels[i] = 255;
  const Result<Segmentation> s = segment_drawing(drawing);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 2U);
}

/// Computes the share of pixels whose labels correspond under the most frequent pairing of labels.
double agreement(const Image16& a, const Image16& b) {
  std::map<std::pair<int, int>, int64_t> together;
  for (size_t i = 0; i < a.pixels.size(); ++i) ++together[{a.pixels[i], b.pixels[i]}];
  std::map<int, int64_t> best;
  for (const auto& [pair, count] : together) best[pair.first] = std::max(best[pair.first], count);
  int64_t sum = 0;
  for (const auto& entry : best) sum += entry.second;
  return static_cast<double>(sum) / static_cast<double>(a.pixels.size());
}

TEST(SegmentDrawing, TurningAndMirroringTheDrawingDoesSoWithTheLabels) {
  const Drawing drawing = snowman().drawing();
  const Result<Segmentation> s = segment_drawing(drawing);
  const Result<Segmentation> quarter = segment_drawing({turned(drawing.rgba)});
  const Result<Segmentation> mirror = segment_drawing({mirrored(drawing.rgba)});
  ASSERT_TRUE(s.ok() && quarter.ok() && mirror.ok());
  EXPECT_EQ(quarter->parts.size(), s->parts.size());
  EXPECT_EQ(mirror->parts.size(), s->parts.size());
  EXPECT_GT(agreement(turned(s->labels), quarter->labels), 0.995);
  EXPECT_GT(agreement(mirrored(s->labels), mirror->labels), 0.995);
}

TEST(SegmentDrawing, SameDrawingGivesTheSame) {
  const Result<Segmentation> a = segment_drawing(snowman().photographed());
  const Result<Segmentation> b = segment_drawing(snowman().photographed());
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(a->labels.pixels, b->labels.pixels);
}

TEST(SegmentDrawing, GapsAreClosedUpToAWidth) {
  int closed_up_to = 0;
  for (int gap = 0; gap <= 400; gap += 20) {
    const double turn = gap / (2 * 3.14159 * 100);
    const Result<Segmentation> s = segment_drawing(
        InkDrawing(320, 320).arc({160, 160}, 100, turn / 2, 1 - turn / 2).drawing());
    const bool closed = s.ok() && label_at(*s, 160, 160) != 0 && label_at(*s, 5, 5) == 0;
    if (!closed) break;
    closed_up_to = gap;
    if (gap > 220) continue;  // no line is missed, the figure is perceived
    EXPECT_EQ(s->bridges.size(), gap > 6 ? 1U : 0U) << gap;
    for (const Bridge& bridge : s->bridges) {
      EXPECT_EQ(bridge.label_a, 0);
      const auto [from, to] = std::pair{bridge.points.front(), bridge.points.back()};
      EXPECT_NEAR(distance(from, to), gap, 16 + gap / 4);
      EXPECT_GT(cross(to - from, Point2{160, 160} - from), 0) << "the inside lies to the right";
    }
  }
  EXPECT_GE(closed_up_to, 60) << "a tenth of the outline";
  EXPECT_LT(closed_up_to, 260) << "an arc of a circle is no area";
}

TEST(SegmentDrawing, FlatColoursWithoutLinesAreSeparatedAtTheirEdges) {
  const Result<Segmentation> s = segment_drawing(InkDrawing(320, 240)
                                                     .disc({120, 120}, 80, 240, 120, 40)
                                                     .disc({210, 120}, 60, 40, 110, 220)
                                                     .drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  ASSERT_EQ(s->parts.size(), 2U);
  EXPECT_NE(label_at(*s, 90, 120), label_at(*s, 230, 120));
  EXPECT_EQ(label_at(*s, 5, 5), 0);
  for (const SegmentedPart& part : s->parts)
    if (part.box.max.x > 260) {
      EXPECT_NEAR(static_cast<double>(part.area), 3.14159 * 3600, 500);
    }
}

TEST(SegmentDrawing, TransparentAreasOfOpaqueFiguresAreHoles) {
  Drawing ring = InkDrawing(240, 240)
                     .disc({120, 120}, 90, 240, 160, 60)
                     .circle({120, 120}, 90)
                     .circle({120, 120}, 40)
                     .drawing();
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 240; ++x) {
      const double radius = distance({x + 0.5, y + 0.5}, {120, 120});
      if (radius > 92 || radius < 38) ring.rgba.at(x, y, 3) = 0;
    }
  const Result<Segmentation> s = segment_drawing(ring);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  ASSERT_EQ(s->parts.size(), 1U);
  EXPECT_EQ(label_at(*s, 120, 120), 0);
  EXPECT_EQ(label_at(*s, 120, 55), 1);
}

InkDrawing stick_figure() {
  InkDrawing stick(300, 400);
  stick.circle({150, 60}, 30).line({150, 90}, {150, 240}).line({150, 120}, {60, 200});
  stick.line({150, 120}, {240, 200}).line({150, 240}, {90, 370}).line({150, 240}, {210, 370});
  return stick;
}

/// Computes the share of the dark pixels that belong to some part.
double kept_ink(const Drawing& drawing, const Segmentation& s) {
  double ink = 0;
  double kept = 0;
  for (size_t i = 0; i < s.labels.pixels.size(); ++i) {
    if (drawing.rgba.pixels[4 * i] > 100) continue;
    ++ink;
    kept += s.labels.pixels[i] != 0 ? 1 : 0;
  }
  return kept / ink;
}

TEST(SegmentDrawing, AStickFigureIsAHeadWithTubes) {
  const Drawing drawing = stick_figure().drawing();
  const Result<Segmentation> s = segment_drawing(drawing);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  ASSERT_EQ(s->parts.size(), 2U);
  EXPECT_EQ(kept_ink(drawing, *s), 1);
  const uint16_t limbs = label_at(*s, 150, 200);
  EXPECT_NE(limbs, 0);
  EXPECT_NE(limbs, label_at(*s, 150, 60));
  for (const auto& [x, y] : {std::pair(65, 196), {235, 196}, {95, 360}, {205, 360}})
    EXPECT_EQ(label_at(*s, x, y), limbs) << x << ", " << y;
  EXPECT_EQ(label_at(*s, 100, 240), 0);
}

TEST(SegmentDrawing, TailsAreTubesAndSpecksAndRuledPaperAreNot) {
  InkDrawing ink(400, 300);
  ink.circle({150, 150}, 80).line({230, 150}, {330, 100}).line({340, 250}, {346, 250});
  ink.line({0, 20}, {400, 20});
  const Result<Segmentation> s = segment_drawing(ink.drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 2U);
  EXPECT_NE(label_at(*s, 310, 110), 0);
  EXPECT_NE(label_at(*s, 310, 110), label_at(*s, 150, 150));
  EXPECT_EQ(label_at(*s, 343, 250), 0) << "a speck";
  EXPECT_EQ(label_at(*s, 300, 20), 0) << "a line of the paper";
}

TEST(SegmentDrawing, StrokesGiveATubeToAPart) {
  const Drawing drawing = stick_figure().drawing();
  Scribbles outside;
  outside.strokes.push_back({ScribbleKind::outside, 0, {{148, 200}, {152, 210}}, 6});
  const Result<Segmentation> head = segment_drawing(drawing, outside);
  ASSERT_TRUE(head.ok()) << to_string(head.error());
  EXPECT_EQ(head->parts.size(), 1U);
  EXPECT_EQ(label_at(*head, 150, 200), 0);

  Scribbles limbs;
  limbs.parts = {"limbs"};
  limbs.strokes.push_back({ScribbleKind::hard, 0, {{150, 190}, {150, 210}}, 3});
  const Result<Segmentation> named = segment_drawing(drawing, limbs);
  ASSERT_TRUE(named.ok()) << to_string(named.error());
  ASSERT_EQ(named->parts.size(), 2U);
  EXPECT_EQ(named->parts[0].id, "limbs");
  EXPECT_EQ(label_at(*named, 95, 360), 1);
}

TEST(SegmentDrawing, StrokesDivideATubeBetweenThem) {
  Scribbles limbs;
  limbs.parts = {"trunk", "leg"};
  limbs.strokes.push_back({ScribbleKind::hard, 0, {{147, 180}, {152, 220}}, 4});
  limbs.strokes.push_back({ScribbleKind::hard, 1, {{100, 350}, {95, 360}}, 4});
  limbs.complete = true;
  const Result<Segmentation> s = segment_drawing(stick_figure().drawing(), limbs);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  ASSERT_EQ(s->parts.size(), 2U);
  EXPECT_EQ(label_at(*s, 150, 200), 1);
  EXPECT_EQ(label_at(*s, 95, 360), 2);
  EXPECT_EQ(label_at(*s, 150, 90), 1) << "the head has no stroke of its own";
  EXPECT_EQ(label_at(*s, 110, 220), 0) << "paper";
}

/// A white head on a painted body, both without an outline.
InkDrawing pale_figure() {
  return InkDrawing(240, 320).disc({120, 90}, 50, 250, 250, 250).disc({120, 200}, 80, 200, 60, 60);
}

TEST(SegmentDrawing, OpaquePixelsOfACutOutPictureAreTheFigure) {
  Drawing drawing = pale_figure().drawing();
  const auto is_cut_out = [](int x, int y) {
    return distance({x * 1.0, y * 1.0}, {120, 90}) > 50 &&
           distance({x * 1.0, y * 1.0}, {120, 200}) > 80;
  };
  const auto is_near_rim = [&](int x, int y) {
    return is_cut_out(x - 3, y) != is_cut_out(x + 3, y) ||
           is_cut_out(x, y - 3) != is_cut_out(x, y + 3);
  };
  for (int y = 0; y < 320; ++y)
    for (int x = 0; x < 240; ++x) drawing.rgba.at(x, y, 3) = is_cut_out(x, y) ? 0 : 255;
  const Result<Segmentation> s = segment_drawing(drawing);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  for (int y = 0; y < 320; ++y)
    for (int x = 0; x < 240; ++x)
      if (!is_near_rim(x, y)) {
        ASSERT_EQ(label_at(*s, x, y) == 0, is_cut_out(x, y)) << x << ", " << y;
      }
}

TEST(SegmentDrawing, PalePaintBelongsToTheFigureAndPaperDoesNot) {
  const Drawing drawing = InkDrawing(240, 320)
                              .disc({120, 90}, 50, 222, 226, 240)
                              .disc({120, 200}, 80, 200, 60, 60)
                              .drawing();
  const Result<Segmentation> s = segment_drawing(drawing);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_NE(label_at(*s, 120, 60), 0);
  EXPECT_NE(label_at(*s, 85, 80), 0);
  EXPECT_NE(label_at(*s, 120, 200), 0);
  EXPECT_EQ(label_at(*s, 50, 90), 0);
  EXPECT_EQ(label_at(*s, 5, 5), 0);
}

/// Discs that cover none and three quarters of the edge.
TEST(SegmentDrawing, NotesThatPartsCoverMostOfTheEdge) {
  for (const double radius : {100.0, 150.0}) {
    InkDrawing face(240, 240);
    face.disc({120, 120}, radius, 230, 170, 60).circle({120, 120}, radius);
    face.disc({80, 90}, 14, 40, 40, 60).disc({160, 90}, 14, 40, 40, 60);
    const Result<Segmentation> s = segment_drawing(face.drawing());
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    const auto tells = [](const std::string& note) {
      return note.find("most of its edge") != std::string::npos;
    };
    EXPECT_EQ(std::any_of(s->notes.begin(), s->notes.end(), tells), radius > 120) << radius;
  }
}

TEST(SegmentDrawing, BlankDrawingsAreRefused) {
  for (const Drawing& drawing : {Drawing(), InkDrawing(50, 40).drawing(),
                                 InkDrawing(99, 99).line({0, 50}, {99, 50}).drawing()}) {
    const Result<Segmentation> none = segment_drawing(drawing);
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().code, ErrorCode::bad_input);
    EXPECT_FALSE(none.error().message.empty());
  }
}

TEST(SegmentDrawing, TinyDrawingsDoNotCrash) {
  for (int width = 1; width <= 6; ++width)
    for (int height = 1; height <= 6; ++height)
      for (uint32_t seed = 0; seed < 8; ++seed) {
        const Drawing drawing{random_image(width, height, 0.7, seed, 4)};
        const Result<Segmentation> s = segment_drawing(drawing);
        if (s.ok()) {
          EXPECT_EQ(s->labels.pixels.size(), drawing.rgba.pixels.size() / 4);
        }
      }
}

}  // namespace
}  // namespace relievo::understanding

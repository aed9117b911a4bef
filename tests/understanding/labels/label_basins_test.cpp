#include "understanding/labels/label_basins.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "support/ink_drawing.h"
#include "understanding/areas/find_basins.h"
#include "understanding/labels/stroke_pixels.h"
#include "understanding/perception/built_in_network.h"

namespace relievo::understanding {
namespace {

Scribble stroke(ScribbleKind kind, int part, std::vector<Point2> points, double width = 5) {
  return {kind, part, std::move(points), width};
}

/// Two rooms with a wall between, and a third one to the right.
Basins rooms() {
  InkDrawing ink(420, 220);
  ink.line({20, 20}, {400, 20}).line({400, 20}, {400, 200}).line({400, 200}, {20, 200});
  ink.line({20, 200}, {20, 20}).line({140, 20}, {140, 200}).line({260, 20}, {260, 200});
  return *find_basins(ink.drawing(), built_in_network());
}

/// One room without any wall.
Basins hall() {
  InkDrawing ink(420, 220);
  ink.line({20, 20}, {400, 20}).line({400, 20}, {400, 200}).line({400, 200}, {20, 200});
  ink.line({20, 200}, {20, 20});
  return *find_basins(ink.drawing(), built_in_network());
}

TEST(LabelBasins, ProposalsAreKeptWhereNobodyDraws) {
  const Basins basins = rooms();
  const Result<Segmentation> s =
      label_basins(basins, {{"left"}, {stroke(ScribbleKind::hard, 0, {{70, 110}, {90, 110}})}});
  ASSERT_TRUE(s.ok());
  ASSERT_EQ(s->parts.size(), 3U);
  EXPECT_EQ(s->parts[0].id, "left");
  EXPECT_FALSE(s->parts[0].proposed);
  EXPECT_TRUE(s->parts[1].proposed);
  EXPECT_EQ(s->labels.at(80, 50), 1);
  EXPECT_NE(s->labels.at(200, 50), s->labels.at(330, 50));
}

/// Counts the pixels of a labelled drawing that are parts, and the parts.
std::pair<int64_t, size_t> figure_of(const Segmentation& s) {
  int64_t area = 0;
  for (const SegmentedPart& part : s.parts) area += part.area;
  return {area, s.parts.size()};
}

TEST(LabelBasins, FewerPartsAreUnionsOfTheProposedOnes) {
  const Basins basins = rooms();
  const Result<Segmentation> found = label_basins(basins);
  ASSERT_TRUE(found.ok());
  ASSERT_EQ(found->parts.size(), 3U);
  for (int count = 3; count >= 1; --count) {
    Scribbles scribbles;
    scribbles.count = count;
    const Result<Segmentation> s = label_basins(basins, scribbles);
    ASSERT_TRUE(s.ok());
    EXPECT_EQ(figure_of(*s), std::make_pair(figure_of(*found).first, static_cast<size_t>(count)));
    std::map<uint16_t, uint16_t> part_of;
    for (size_t i = 0; i < s->labels.pixels.size(); ++i) {
      const auto entry = part_of.try_emplace(found->labels.pixels[i], s->labels.pixels[i]).first;
      ASSERT_EQ(entry->second, s->labels.pixels[i]);
    }
  }
}

/// A dumb-bell without a line across: two halls and a passage between.
Basins dumb_bell() {
  InkDrawing ink(520, 240);
  ink.line({20, 20}, {200, 20}).line({200, 20}, {200, 95}).line({200, 95}, {320, 95});
  ink.line({320, 95}, {320, 20}).line({320, 20}, {500, 20}).line({500, 20}, {500, 220});
  ink.line({500, 220}, {320, 220}).line({320, 220}, {320, 145}).line({320, 145}, {200, 145});
  ink.line({200, 145}, {200, 220}).line({200, 220}, {20, 220}).line({20, 220}, {20, 20});
  return *find_basins(ink.drawing(), built_in_network());
}

TEST(LabelBasins, MorePartsDivideAnAreaWhereItIsNarrow) {
  const Basins basins = dumb_bell();
  Scribbles one;
  one.count = 1;
  const Result<Segmentation> whole = label_basins(basins, one);
  ASSERT_TRUE(whole.ok());
  ASSERT_EQ(whole->parts.size(), 1U);
  Scribbles two;
  two.count = 2;
  const Result<Segmentation> s = label_basins(basins, two);
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(figure_of(*s), std::make_pair(figure_of(*whole).first, size_t{2}));
  EXPECT_NE(s->labels.at(110, 120), s->labels.at(410, 120));
  EXPECT_EQ(s->labels.at(60, 60), s->labels.at(160, 180));
  EXPECT_EQ(s->labels.at(360, 60), s->labels.at(460, 180));
}

TEST(LabelBasins, TooManyPartsAreAsManyAsPossible) {
  const Basins basins = rooms();
  Scribbles scribbles;
  scribbles.count = 1000;
  const Result<Segmentation> many = label_basins(basins, scribbles);
  ASSERT_TRUE(many.ok());
  EXPECT_GE(many->parts.size(), 3U);
  EXPECT_LE(many->parts.size(), basins.basins.size());
  scribbles.count = -1;
  EXPECT_FALSE(label_basins(basins, scribbles).ok());
}

TEST(LabelBasins, OneStrokeOverSeveralAreasMakesThemOnePart) {
  const Result<Segmentation> s =
      label_basins(rooms(), {{"both"}, {stroke(ScribbleKind::soft, 0, {{80, 110}, {200, 110}})}});
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->parts.size(), 2U);
  EXPECT_EQ(s->labels.at(80, 50), s->labels.at(200, 50));
}

TEST(LabelBasins, CompleteStrokesLeaveNoOtherParts) {
  const Scribbles scribbles{
      {"a", "b"},
      {stroke(ScribbleKind::hard, 0, {{80, 110}}), stroke(ScribbleKind::hard, 1, {{330, 110}})},
      true};
  const Result<Segmentation> s = label_basins(rooms(), scribbles);
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->parts.size(), 2U);
  EXPECT_NE(s->labels.at(80, 50), s->labels.at(330, 50));
}

TEST(LabelBasins, HardStrokesAreNeverOverruled) {
  const Basins basins = hall();
  for (int k = 0; k < 12; ++k) {
    const double x = 60 + 22 * k;
    const Scribbles scribbles{{"a", "b"},
                              {stroke(ScribbleKind::hard, 0, {{40, 110}, {60, 150}}),
                               stroke(ScribbleKind::hard, 1, {{x + 20, 60}, {x + 40, 160}}, 3)}};
    const Result<Segmentation> s = label_basins(basins, scribbles);
    ASSERT_TRUE(s.ok());
    for (const StrokePixel& mark :
         stroke_pixels(scribbles, basins.index.width, basins.index.height)) {
      const std::string& id = scribbles.parts[scribbles.strokes[mark.stroke].part];
      ASSERT_EQ(s->parts[s->labels.pixels[mark.pixel] - 1].id, id) << k;
    }
  }
}

TEST(LabelBasins, HardStrokesDivideAnOpenAreaBetweenThem) {
  const Result<Segmentation> s =
      label_basins(hall(), {{"a", "b"},
                            {stroke(ScribbleKind::hard, 0, {{60, 60}, {60, 160}}),
                             stroke(ScribbleKind::hard, 1, {{360, 60}, {360, 160}})}});
  ASSERT_TRUE(s.ok());
  ASSERT_EQ(s->parts.size(), 2U);
  EXPECT_NEAR(static_cast<double>(s->parts[0].area) / static_cast<double>(s->parts[1].area), 1,
              0.1);
  EXPECT_FALSE(s->bridges.empty());
}

TEST(LabelBasins, SoftStrokesVote) {
  const Result<Segmentation> s =
      label_basins(hall(), {{"much", "little"},
                            {stroke(ScribbleKind::soft, 0, {{60, 60}, {300, 160}}),
                             stroke(ScribbleKind::soft, 1, {{360, 60}, {370, 60}})}});
  ASSERT_TRUE(s.ok());
  ASSERT_EQ(s->parts.size(), 1U);
  EXPECT_EQ(s->parts[0].id, "much");
  ASSERT_EQ(s->notes.size(), 1U);
  EXPECT_NE(s->notes[0].find("little"), std::string::npos);
}

TEST(LabelBasins, ASlipOverALineIsForgiven) {
  const Result<Segmentation> s =
      label_basins(rooms(), {{"left"}, {stroke(ScribbleKind::hard, 0, {{40, 110}, {146, 110}})}});
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->labels.at(80, 50), 1);
  EXPECT_NE(s->labels.at(200, 50), 1);
}

TEST(LabelBasins, CompleteStrokesTakeAreasOfTheirColour) {
  InkDrawing ink(420, 220);
  ink.line({20, 20}, {400, 20}).line({400, 20}, {400, 200}).line({400, 200}, {20, 200});
  ink.line({20, 200}, {20, 20}).line({140, 20}, {140, 200}).line({260, 20}, {260, 200});
  Drawing drawing = ink.drawing();
  for (int y = 25; y < 195; ++y)
    for (int x = 145; x < 395; ++x)
      if (x < 255 || x > 265) drawing.rgba.at(x, y, 2) = 60;
  const Result<Segmentation> s =
      label_basins(*find_basins(drawing, built_in_network()),
                   {{"white", "yellow"},
                    {stroke(ScribbleKind::hard, 0, {{80, 60}, {80, 160}}),
                     stroke(ScribbleKind::hard, 1, {{330, 110}})},
                    true});
  ASSERT_TRUE(s.ok());
  ASSERT_EQ(s->parts.size(), 2U);
  EXPECT_EQ(s->labels.at(200, 110), 2);
}

TEST(LabelBasins, StrokesForPartsNeverFloodThePage) {
  for (const double x : {330.0, 380.0, 395.0}) {
    const Result<Segmentation> s =
        label_basins(hall(), {{"a"}, {stroke(ScribbleKind::hard, 0, {{x, 110}, {415, 110}})}});
    ASSERT_TRUE(s.ok());
    EXPECT_EQ(s->labels.at(10, 110), 0) << x;
    EXPECT_EQ(s->labels.at(200, 10), 0) << x;
    EXPECT_EQ(s->labels.at(418, 4), 0) << x;
    EXPECT_NE(s->labels.at(200, 110), 0) << x;
  }
}

TEST(LabelBasins, HolesAndOutsideBecomeBackground) {
  for (const ScribbleKind kind : {ScribbleKind::outside, ScribbleKind::hole}) {
    const Result<Segmentation> s = label_basins(rooms(), {{}, {stroke(kind, 0, {{200, 110}})}});
    ASSERT_TRUE(s.ok());
    EXPECT_EQ(s->parts.size(), 2U);
    EXPECT_EQ(s->labels.at(200, 50), 0);
    EXPECT_NE(s->labels.at(80, 50), 0);
  }
}

TEST(LabelBasins, LaterStrokesCoverEarlierOnes) {
  const Result<Segmentation> s =
      label_basins(rooms(), {{"a", "b"},
                             {stroke(ScribbleKind::hard, 0, {{60, 110}, {100, 110}}),
                              stroke(ScribbleKind::hard, 1, {{60, 110}, {100, 110}})}});
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->parts[s->labels.at(80, 50) - 1].id, "b");
}

TEST(LabelBasins, StrokesMayLieOnTheBackground) {
  const Basins basins = hall();
  const Result<Segmentation> s =
      label_basins(basins, {{"cloud"}, {stroke(ScribbleKind::hard, 0, {{5, 215}, {9, 215}}, 3)}});
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->labels.at(7, 215), 1);
}

TEST(LabelBasins, BadStrokesAreRefused) {
  const Basins basins = hall();
  const double inf = std::numeric_limits<double>::infinity();
  for (const Scribbles& bad :
       std::vector<Scribbles>{{{"a", "a"}, {}},
                              {{""}, {}},
                              {{"a"}, {stroke(ScribbleKind::hard, 1, {{5, 5}})}},
                              {{"a"}, {stroke(ScribbleKind::soft, -1, {{5, 5}})}},
                              {{"a"}, {stroke(ScribbleKind::hard, 0, {})}},
                              {{"a"}, {stroke(ScribbleKind::hard, 0, {{inf, 5}})}},
                              {{"a"}, {stroke(ScribbleKind::hard, 0, {{5, 5}}, 0)}}}) {
    const Result<Segmentation> s = label_basins(basins, bad);
    ASSERT_FALSE(s.ok());
    EXPECT_EQ(s.error().code, ErrorCode::bad_input);
    EXPECT_EQ(to_string(s.error().culprit), bad.strokes.empty() ? "" : "strokes[0]");
  }
}

TEST(FindBasins, StopsBetweenAnyTwoSteps) {
  const Drawing drawing = InkDrawing(120, 120).circle({60, 60}, 40).drawing();
  int steps = 0;
  RunContext count;
  double last = -1;
  count.progress = [&](const char*, double fraction) {
    EXPECT_GT(fraction, last);
    last = fraction;
    ++steps;
  };
  ASSERT_TRUE(find_basins(drawing, built_in_network(), count).ok());
  EXPECT_EQ(last, 1);
  for (int stop = 0; stop + 1 < steps; ++stop) {
    std::atomic<bool> cancel = false;
    RunContext context{&cancel};
    int left = stop;
    context.progress = [&](const char*, double) { cancel = left-- == 0 || cancel; };
    const auto basins = find_basins(drawing, built_in_network(), context);
    ASSERT_FALSE(basins.ok()) << stop;
    EXPECT_EQ(basins.error().code, ErrorCode::interrupted);
  }
}

}  // namespace
}  // namespace relievo::understanding

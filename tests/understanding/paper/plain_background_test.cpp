#include "understanding/paper/plain_background.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/ink_drawing.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

using Colour = std::array<uint8_t, 3>;

constexpr Colour sky = {190, 225, 245};
constexpr Colour night = {40, 40, 48};
constexpr Colour cream = {244, 236, 216};

/// A red ring around background, a yellow disc on it that is half as wide, on a background of one
/// colour, with the blend of paint and background that a renderer leaves.
Drawing ring_on(const Colour& background) {
  Drawing drawing{Image8(400, 300, 4, 255)};
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) {
      const Point2 p{x + 0.5, y + 0.5};
      const double ring = std::max(distance(p, {150, 150}) - 110, 50 - distance(p, {150, 150}));
      const double disc = distance(p, {300, 150}) - 60;
      const double red = std::clamp(0.5 - ring, 0.0, 1.0);
      const double yellow = std::clamp(0.5 - disc, 0.0, 1.0);
      for (int c = 0; c < 3; ++c) {
        const std::array<double, 3> paint = {200.0, 60.0, 50.0};
        const std::array<double, 3> other = {240.0, 210.0, 80.0};
        const double under = red * paint[c] + (1 - red) * background[c];
        drawing.rgba.at(x, y, c) =
            static_cast<uint8_t>(yellow * other[c] + (1 - yellow) * under + 0.5);
      }
    }
  return drawing;
}

TEST(PlainBackground, IsNoPartOfTheFigureWhateverItsColour) {
  for (const Colour& background : {sky, night, cream}) {
    const Result<Segmentation> s = segment_drawing(ring_on(background));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), background == night ? 3U : 2U) << int{background[0]};
    EXPECT_EQ(s->labels.at(10, 10), 0) << int{background[0]};
    EXPECT_NE(s->labels.at(150, 70), 0) << int{background[0]};
    EXPECT_NE(s->labels.at(320, 150), s->labels.at(150, 70)) << int{background[0]};
  }
}

TEST(PlainBackground, ShowsThroughAPaintedFigureUnlessItMayBeInk) {
  EXPECT_EQ(segment_drawing(ring_on(sky))->labels.at(150, 150), 0);
  EXPECT_NE(segment_drawing(ring_on(night))->labels.at(150, 150), 0);
}

TEST(PlainBackground, LeavesNoBlendAtTheRim) {
  const Image8 cut = without_background(ring_on(night).rgba).rgba;
  ASSERT_FALSE(cut.empty());
  for (size_t i = 0; i < cut.pixels.size(); i += 4) {
    if (cut.pixels[i + 3] == 0) continue;
    const bool through = cut.pixels[i] == night[0] && cut.pixels[i + 1] == night[1];
    const bool red = cut.pixels[i] == 200 && cut.pixels[i + 1] == 60;
    const bool yellow = cut.pixels[i] == 240 && cut.pixels[i + 1] == 210;
    const auto x = static_cast<int>(i / 4 % 400);
    const auto y = static_cast<int>(i / 4 / 400);
    const double to_hole = distance({x + 0.5, y + 0.5}, {150, 150});
    const bool at_other_paint = distance({x + 0.5, y + 0.5}, {300, 150}) < 62;
    EXPECT_TRUE(red || yellow || through || to_hole < 52 || at_other_paint) << x << ", " << y;
  }
}

TEST(PlainBackground, LeavesWhiteFiguresWhole) {
  Drawing drawing{Image8(400, 300, 4, 255)};
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x)
      for (int c = 0; c < 3 && distance({x + 0.5, y + 0.5}, {200, 150}) > 100; ++c)
        drawing.rgba.at(x, y, c) = static_cast<uint8_t>(60 + 50 * c);
  EXPECT_TRUE(without_background(drawing.rgba).is_cut);
  const Result<Segmentation> s = segment_drawing(drawing);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->labels.at(5, 5), 0);
  EXPECT_NE(s->labels.at(200, 150), 0);
}

/// A circle with a gap and a whole one, in lines of one colour on a background of another.
Drawing lines_on(const Colour& background, const Colour& ink) {
  InkDrawing lines(400, 300);
  lines.arc({130, 150}, 80, 0.02, 0.98, 7).circle({290, 150}, 70, 7);
  Drawing drawing = lines.drawing();
  for (size_t i = 0; i < drawing.rgba.pixels.size(); i += 4) {
    const double share = drawing.rgba.pixels[i] / 255.0;
    for (size_t c = 0; c < 3; ++c)
      drawing.rgba.pixels[i + c] =
          static_cast<uint8_t>(share * background[c] + (1 - share) * ink[c] + 0.5);
  }
  return drawing;
}

TEST(PlainBackground, FillsAreasBetweenLines) {
  for (const Colour& background : {cream, sky, Colour{255, 255, 255}}) {
    const Result<Segmentation> s = segment_drawing(lines_on(background, {20, 20, 20}));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_NE(s->labels.at(130, 150), 0) << int{background[2]} << ", with a gap";
    EXPECT_NE(s->labels.at(290, 150), 0) << int{background[2]};
    EXPECT_EQ(s->labels.at(8, 8), 0) << int{background[2]};
  }
}

TEST(PlainBackground, IsABlackboardUnderChalk) {
  const Result<Segmentation> s = segment_drawing(lines_on(night, {245, 245, 245}));
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_NE(s->labels.at(290, 150), 0);
  EXPECT_EQ(s->labels.at(8, 8), 0);
}

TEST(PlainBackground, IsNoWhitePaperAndNoFrame) {
  EXPECT_TRUE(without_background(ring_on({255, 255, 255}).rgba).rgba.empty());
  Image8 framed(300, 200, 4, 255);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      const bool frame = x < 12 || y < 12 || x >= 288 || y >= 188;
      for (int c = 0; c < 3; ++c)
        framed.at(x, y, c) = static_cast<uint8_t>(frame ? 0 : 205 + (x * 7 + y * 3) % 40);
    }
  EXPECT_FALSE(without_background(framed).is_cut);
}

/// Photographs a drawing: the light falls off towards one corner by 30 %, and there is grain.
Drawing photographed(Drawing drawing) {
  Image8& rgba = drawing.rgba;
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      const double light = 1 - 0.3 * (x + y) / (rgba.width + rgba.height);
      const int grain = (x * 7919 + y * 104729 + x * y * 31) % 13 - 6;
      for (int c = 0; c < 3; ++c)
        rgba.at(x, y, c) =
            static_cast<uint8_t>(std::clamp(rgba.at(x, y, c) * light + grain, 0.0, 255.0));
    }
  return drawing;
}

constexpr Colour kraft = {184, 148, 107};
constexpr Colour moss = {100, 114, 97};

TEST(PlainBackground, MayHaveGrainAndShadows) {
  for (const Colour& background : {kraft, moss, night}) {
    const Result<Segmentation> s = segment_drawing(photographed(ring_on(background)));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), background == night ? 3U : 2U) << int{background[0]};
    for (const auto& [x, y] : {std::pair(3, 3), {396, 3}, {3, 296}, {396, 296}, {200, 20}})
      EXPECT_EQ(s->labels.at(x, y), 0) << int{background[0]} << " at " << x << ", " << y;
    EXPECT_EQ(s->labels.at(150, 150) == 0, background != night) << int{background[0]};
    EXPECT_NE(s->labels.at(150, 70), 0) << int{background[0]};
    EXPECT_NE(s->labels.at(320, 150), s->labels.at(150, 70)) << int{background[0]};
  }
}

TEST(PlainBackground, DoesNotShowThroughAreasOfNearlyItsColour) {
  Drawing drawing = ring_on(moss);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x)
      for (int c = 0; c < 3 && distance({x + 0.5, y + 0.5}, {150, 150}) < 50; ++c)
        drawing.rgba.at(x, y, c) = static_cast<uint8_t>(moss[c] - 8);
  EXPECT_NE(segment_drawing(photographed(drawing))->labels.at(150, 150), 0);
}

TEST(PlainBackground, IsTheColourOfMostOfTheBorder) {
  const Drawing whole = ring_on(moss);
  Drawing bust{Image8(400, 180, 4, 255)};
  std::copy_n(whole.rgba.pixels.begin(), bust.rgba.pixels.size(), bust.rgba.pixels.begin());
  for (const Drawing& drawing : {bust, photographed(bust)}) {
    const Result<Segmentation> s = segment_drawing(drawing);
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->labels.at(5, 170), 0);
    EXPECT_NE(s->labels.at(70, 176), 0);
    EXPECT_NE(s->labels.at(300, 176), 0);
  }
}

TEST(PlainBackground, IsNoPaperUnderPaint) {
  const Drawing dark = lines_on(kraft, {60, 40, 30});
  EXPECT_TRUE(without_background(photographed(dark).rgba).rgba.empty());
  Drawing shaded = ring_on({215, 212, 205});
  for (size_t i = 0; i < shaded.rgba.pixels.size(); ++i)
    shaded.rgba.pixels[i] = i % 4 == 0 && shaded.rgba.pixels[i] > 200 ? 200 : shaded.rgba.pixels[i];
  EXPECT_TRUE(without_background(photographed(shaded).rgba).rgba.empty());
}

/// The ring's drawing on a page that lies turned on a table.
Drawing page_on(const Colour& table) {
  Drawing photo{Image8(480, 420, 4, 255)};
  const Drawing page = ring_on({250, 246, 240});
  for (int y = 0; y < 420; ++y)
    for (int x = 0; x < 480; ++x) {
      const int u = x - 40 + y / 15;
      const int v = y - 60 - x / 20;
      const bool on_page = u >= 0 && v >= 0 && u < 400 && v < 300;
      for (int c = 0; c < 3; ++c)
        photo.rgba.at(x, y, c) = on_page ? page.rgba.at(u, v, c) : table[c];
    }
  return photographed(photo);
}

TEST(PageOnATable, IsContinuedOverIt) {
  for (const Colour& table : {kraft, moss, night}) {
    const Drawing photo = page_on(table);
    const auto [spread, is_cut] = without_background(photo.rgba);
    ASSERT_FALSE(spread.empty() || is_cut) << int{table[0]};
    EXPECT_NEAR(spread.at(2, 2, 1), 246, 12) << int{table[0]};
    EXPECT_NEAR(spread.at(470, 410, 1), 246 * 0.7, 12) << int{table[0]};
    EXPECT_EQ(spread.at(240, 230, 0), photo.rgba.at(240, 230, 0)) << int{table[0]};
    const Result<Segmentation> s = segment_drawing(photo);
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), 3U) << int{table[0]};  // with what the ring encloses
    for (const auto& [x, y] : {std::pair(3, 3), {476, 3}, {3, 416}, {476, 416}, {30, 90}})
      EXPECT_EQ(s->labels.at(x, y), 0) << int{table[0]} << " at " << x << ", " << y;
  }
}

TEST(PageOnATable, IsNoFigureOnPaper) {
  EXPECT_TRUE(without_background(photographed(ring_on(moss)).rgba).is_cut);
  Drawing robot{Image8(400, 300, 4, 255)};  // a box whose rim has two colours
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) {
      const bool inside = x > 60 && x < 340 && y > 40 && y < 260;
      for (int c = 0; c < 3; ++c)
        robot.rgba.at(x, y, c) = static_cast<uint8_t>(!inside ? moss[c] : y < 150 ? 230 : 60 * c);
    }
  EXPECT_TRUE(without_background(photographed(robot).rgba).is_cut);
}

}  // namespace
}  // namespace relievo::understanding

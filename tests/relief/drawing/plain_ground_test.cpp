#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "relief/drawing/figure_mask.h"
#include "relief/drawing/segment_drawing.h"
#include "support/ink_drawing.h"

namespace relievo {
namespace {

using Colour = std::array<uint8_t, 3>;

constexpr Colour sky = {190, 225, 245};
constexpr Colour night = {40, 40, 48};
constexpr Colour cream = {244, 236, 216};

/// A red ring around ground, a yellow disc on it that is half as wide, on a ground of one colour,
/// with the blend of paint and ground that a renderer leaves.
Drawing ring_on(const Colour& ground) {
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
        const double under = red * paint[c] + (1 - red) * ground[c];
        drawing.rgba.at(x, y, c) =
            static_cast<uint8_t>(yellow * other[c] + (1 - yellow) * under + 0.5);
      }
    }
  return drawing;
}

TEST(PlainGround, IsNoPartOfTheFigureWhateverItsColour) {
  for (const Colour& ground : {sky, night, cream}) {
    const Result<Segmentation> s = segment_drawing(ring_on(ground));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), ground == night ? 3U : 2U) << int{ground[0]};
    EXPECT_EQ(s->labels.at(10, 10), 0) << int{ground[0]};
    EXPECT_NE(s->labels.at(150, 70), 0) << int{ground[0]};
    EXPECT_NE(s->labels.at(320, 150), s->labels.at(150, 70)) << int{ground[0]};
  }
}

TEST(PlainGround, ShowsThroughAPaintedFigureUnlessItMayBeInk) {
  EXPECT_EQ(segment_drawing(ring_on(sky))->labels.at(150, 150), 0);
  EXPECT_NE(segment_drawing(ring_on(night))->labels.at(150, 150), 0);
}

TEST(PlainGround, LeavesNoBlendAtTheRim) {
  const Image8 cut = cut_from_plain_ground(ring_on(night).rgba);
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

/// A circle with a gap and a whole one, in lines of one colour on a ground of another.
Drawing lines_on(const Colour& ground, const Colour& ink) {
  InkDrawing lines(400, 300);
  lines.arc({130, 150}, 80, 0.02, 0.98, 7).circle({290, 150}, 70, 7);
  Drawing drawing = lines.drawing();
  for (size_t i = 0; i < drawing.rgba.pixels.size(); i += 4) {
    const double share = drawing.rgba.pixels[i] / 255.0;
    for (size_t c = 0; c < 3; ++c)
      drawing.rgba.pixels[i + c] =
          static_cast<uint8_t>(share * ground[c] + (1 - share) * ink[c] + 0.5);
  }
  return drawing;
}

TEST(PlainGround, FillsWhatLinesBound) {
  for (const Colour& ground : {cream, sky, Colour{255, 255, 255}}) {
    const Result<Segmentation> s = segment_drawing(lines_on(ground, {20, 20, 20}));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_NE(s->labels.at(130, 150), 0) << int{ground[2]} << ", with a gap";
    EXPECT_NE(s->labels.at(290, 150), 0) << int{ground[2]};
    EXPECT_EQ(s->labels.at(8, 8), 0) << int{ground[2]};
  }
}

TEST(PlainGround, IsABlackboardUnderChalk) {
  const Result<Segmentation> s = segment_drawing(lines_on(night, {245, 245, 245}));
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_NE(s->labels.at(290, 150), 0);
  EXPECT_EQ(s->labels.at(8, 8), 0);
}

TEST(PlainGround, IsNoWhitePaperAndNoFrame) {
  EXPECT_TRUE(cut_from_plain_ground(ring_on({255, 255, 255}).rgba).empty());
  Image8 framed(300, 200, 4, 255);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      const bool frame = x < 12 || y < 12 || x >= 288 || y >= 188;
      for (int c = 0; c < 3; ++c)
        framed.at(x, y, c) = static_cast<uint8_t>(frame ? 0 : 205 + (x * 7 + y * 3) % 40);
    }
  EXPECT_TRUE(cut_from_plain_ground(framed).empty());
}

}  // namespace
}  // namespace relievo

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "understanding/labels/segment_drawing.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

/// White paper with grain that is darker by up to `grain`.
Image8 paper(int width, int height, int grain) {
  Image8 rgba(width, height, 4, 255);
  std::mt19937 random(7);
  for (size_t i = 0; i < rgba.pixels.size(); i += 4) {
    const auto value = static_cast<uint8_t>(255 - (grain > 0 ? random() % (grain + 1) : 0));
    for (size_t c = 0; c < 3; ++c) rgba.pixels[i + c] = value;
  }
  return rgba;
}

void darken(Image8& rgba, int x, int y, double by) {
  for (int c = 0; c < 3; ++c)
    rgba.at(x, y, c) = static_cast<uint8_t>(std::max(0.0, rgba.at(x, y, c) - by));
}

/// A blurred ring, 2.5 px wide, whose contrast falls from 170 at the left to `faintest` at the
/// right.
Drawing fading_ring(int faintest, int grain) {
  Drawing drawing{paper(320, 320, grain)};
  for (int y = 0; y < 320; ++y)
    for (int x = 0; x < 320; ++x) {
      const Point2 p{x + 0.5 - 160, y + 0.5 - 160};
      const double off = std::abs(std::hypot(p.x, p.y) - 110);
      const double toward_right = 0.5 + p.x / 220;
      const double contrast = 170 + (faintest - 170) * std::min(1.0, 1.6 * toward_right);
      darken(drawing.rgba, x, y, contrast * std::clamp(2 - off, 0.0, 1.0));
    }
  return drawing;
}

TEST(LineArt, IsClosedWhereAPencilHardlyMarksThePaper) {
  for (const auto& [faintest, grain] : {std::pair(18, 0), {40, 0}, {60, 6}}) {
    const Result<Segmentation> s = segment_drawing(fading_ring(faintest, grain));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), 1U) << faintest;
    EXPECT_NE(s->labels.at(160, 160), 0) << faintest;
    EXPECT_NEAR(static_cast<double>(s->parts[0].area), std::numbers::pi * 111 * 111,
                0.03 * std::numbers::pi * 111 * 111)
        << faintest;
  }
}

TEST(LineArt, DoesNotTakeGrainForLines) {
  const Result<Segmentation> s = segment_drawing(fading_ring(80, 14));
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 1U);
  EXPECT_EQ(s->labels.at(5, 5), 0);
}

/// Two rings, and a black wedge between them that is wider than lines.
Drawing figure_with_black_neck() {
  Drawing drawing{paper(500, 700, 0)};
  const auto ring = [](Point2 p, Point2 middle) { return std::abs(distance(p, middle) - 120) < 3; };
  for (int y = 0; y < 700; ++y)
    for (int x = 0; x < 500; ++x) {
      const Point2 p{x + 0.5, y + 0.5};
      const bool neck = p.y > 270 && p.y < 450 && std::abs(p.x - 250) < 11 + 0.09 * (p.y - 270);
      if (neck || ring(p, {250, 160}) || ring(p, {250, 560})) darken(drawing.rgba, x, y, 235);
    }
  return drawing;
}

TEST(LineArt, LosesNoDarkShape) {
  const Drawing drawing = figure_with_black_neck();
  const Result<Segmentation> s = segment_drawing(drawing);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  int lost = 0;
  int neck = 0;
  for (int y = 290; y < 440; ++y)
    for (int x = 0; x < 500; ++x) {
      if (drawing.rgba.at(x, y) >= 128) continue;
      ++neck;
      lost += s->labels.at(x, y) == 0 ? 1 : 0;
    }
  EXPECT_LT(lost, 0.01 * neck);
}

/// A face filled by slanted strokes of a yellow pencil with paper between them, in a black outline,
/// in the middle of a page.
Image8 crayon_face(int page) {
  Image8 rgb(page, page, 3, 255);
  for (int y = 0; y < page; ++y)
    for (int x = 0; x < page; ++x) {
      const double r = distance({x + 0.5, y + 0.5}, {page / 2.0, page / 2.0});
      const bool outline = r > 50;
      if (r > 52 || (!outline && (x + 2 * y) % 11 == 10)) continue;
      const std::array<uint8_t, 3> yellow = {240, 200, 40};
      for (int c = 0; c < 3; ++c) rgb.at(x, y, c) = outline ? 30 : yellow[c];
    }
  return rgb;
}

TEST(LineArt, ASmallColouredFigureIsNone) {
  for (const int page : {200, 400, 700}) EXPECT_TRUE(find_lines(crayon_face(page)).painted) << page;
}

}  // namespace
}  // namespace relievo::understanding

#include "understanding/paper/pure_white.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/ink_drawing.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

/// A grey head with two ears, without a line, whose grey differs from white by `contrast`.
Drawing mouse(int contrast) {
  const auto grey = static_cast<uint8_t>(255 - contrast);
  InkDrawing mouse(400, 360);
  mouse.disc({110, 100}, 70, grey, grey, grey).disc({290, 100}, 70, grey, grey, grey);
  mouse.disc({110, 100}, 45, 255, 190, 205).disc({290, 100}, 45, 255, 190, 205);
  mouse.disc({200, 220}, 100, grey, grey, grey);
  mouse.disc({160, 200}, 14, 50, 50, 60).disc({240, 200}, 14, 50, 50, 60);
  return mouse.drawing();
}

class PaleFigure : public ::testing::TestWithParam<int> {};

TEST_P(PaleFigure, IsWholeOnPureWhite) {
  const Result<Segmentation> s = segment_drawing(mouse(GetParam()));
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  int off = 0;
  for (int y = 0; y < 360; ++y)
    for (int x = 0; x < 400; ++x) {
      const Point2 p{x + 0.5, y + 0.5};
      const double outside = std::min({distance(p, {110, 100}) - 70, distance(p, {290, 100}) - 70,
                                       distance(p, {200, 220}) - 100});
      if (std::abs(outside) < 3) continue;
      off += (outside < 0) != (s->labels.at(x, y) != 0) ? 1 : 0;
    }
  EXPECT_LT(off, 40) << "px that are figure and should not be, or the other way round";
  EXPECT_EQ(s->labels.at(120, 240), s->labels.at(280, 240)) << "both cheeks";
  EXPECT_EQ(s->labels.at(200, 140), s->labels.at(200, 300)) << "forehead and chin";
}

INSTANTIATE_TEST_SUITE_P(Contrasts, PaleFigure, ::testing::Values(14, 25, 35, 58, 90));

/// The lower edge cuts off the bust along four fifths of its length.
TEST(PureWhite, MayBePartlyCoveredByABust) {
  for (const int level : {230, 220, 165}) {
    const auto grey = static_cast<uint8_t>(level);
    InkDrawing bust(300, 260);
    bust.disc({150, 240}, 120, grey, grey, grey).disc({150, 90}, 70, grey, grey, grey);
    bust.disc({120, 80}, 10, 50, 50, 60).disc({180, 80}, 10, 50, 50, 60);
    const Result<Segmentation> s = segment_drawing(bust.drawing());
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    for (int y = 0; y < 260; ++y)
      for (int x = 0; x < 300; ++x) {
        const Point2 p{x + 0.5, y + 0.5};
        const double outside = std::min(distance(p, {150, 240}) - 120, distance(p, {150, 90}) - 70);
        if (std::abs(outside) < 4) continue;
        ASSERT_EQ(outside < 0, s->labels.at(x, y) != 0) << level << " at " << x << ", " << y;
      }
  }
}

/// The shading of a pale ball is no light on paper, which would be divided out.
TEST(PureWhite, KeepsTheShadingOfAPaleBall) {
  Image8 ball(300, 300, 4, 255);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x) {
      if (distance({x + 0.5, y + 0.5}, {150, 150}) >= 120) continue;
      const auto grey = static_cast<uint8_t>(std::lround(219 + 0.14 * (x - y)));
      for (int c = 0; c < 3; ++c) ball.at(x, y, c) = grey;
    }
  const Result<Segmentation> s = segment_drawing({ball});
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 1U);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x) {
      const double outside = distance({x + 0.5, y + 0.5}, {150, 150}) - 120;
      if (std::abs(outside) < 3) continue;
      ASSERT_EQ(outside < 0, s->labels.at(x, y) != 0) << x << ", " << y;
    }
}

TEST(PureWhite, IsNotThePaperOfAPhotographOrAScan) {
  EXPECT_TRUE(is_on_pure_white(mouse(40).rgba));
  Image8 grainy = mouse(40).rgba;
  for (size_t i = 0; i < grainy.pixels.size(); i += 4)
    for (size_t c = 0; c < 3; ++c)
      grainy.pixels[i + c] = static_cast<uint8_t>(grainy.pixels[i + c] - (i / 4) % 5);
  EXPECT_FALSE(is_on_pure_white(grainy));
  Image8 framed(300, 200, 4, 255);
  for (int y = 20; y < 180; ++y)
    for (int x = 20; x < 280; ++x)
      for (int c = 0; c < 3; ++c) framed.at(x, y, c) = static_cast<uint8_t>(225 + (x + y) % 7);
  EXPECT_FALSE(is_on_pure_white(framed)) << "a photograph in a white frame";
}

TEST(PureWhite, IncludesTransparency) {
  Drawing cut_out = mouse(20);
  for (size_t i = 0; i < cut_out.rgba.pixels.size(); i += 4)
    if (cut_out.rgba.pixels[i + 1] == 255)
      for (size_t c = 0; c < 4; ++c) cut_out.rgba.pixels[i + c] = 0;
  EXPECT_TRUE(is_on_pure_white(cut_out.rgba));
  const Result<Segmentation> s = segment_drawing(cut_out);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_NE(s->labels.at(200, 260), 0);
  EXPECT_EQ(s->labels.at(5, 5), 0);
}

/// A ball, with an outline of that width, above a grey ellipse on the ground that fades within
/// `blur` px.
Drawing ball_above_shadow(double blur, double outline = 0) {
  InkDrawing ball(400, 360);
  ball.disc({200, 180}, 110, 40, 30, 35).disc({200, 180}, 110 - outline, 230, 120, 40);
  Drawing drawing = ball.drawing();
  for (int y = 0; y < 360; ++y)
    for (int x = 0; x < 400; ++x) {
      if (drawing.rgba.at(x, y, 2) != 255) continue;
      const double inside = 22 * (1 - std::hypot((x + 0.5 - 200) / 120, (y + 0.5 - 300) / 22));
      const double share = std::clamp(0.5 + inside / blur, 0.0, 1.0);
      for (int c = 0; c < 3; ++c) drawing.rgba.at(x, y, c) = static_cast<uint8_t>(255 - 75 * share);
    }
  return drawing;
}

TEST(CastShadow, IsNoPart) {
  for (const double blur : {1, 30})
    for (const double outline : {0, 8}) {
      const Result<Segmentation> s = segment_drawing(ball_above_shadow(blur, outline));
      ASSERT_TRUE(s.ok()) << to_string(s.error());
      EXPECT_EQ(s->labels.at(110, 302), 0) << blur << ", " << outline;
      EXPECT_EQ(s->labels.at(200, 304), 0) << blur << ", " << outline;
      EXPECT_NE(s->labels.at(200, 270), 0) << "the ball";
    }
}

TEST(CastShadow, APlateWithAnOutlineIsNone) {
  Drawing plate = ball_above_shadow(1, 8);
  for (int y = 0; y < 360; ++y)
    for (int x = 0; x < 400; ++x) {
      const double r = std::hypot((x + 0.5 - 200) / 120, (y + 0.5 - 300) / 22);
      if (plate.rgba.at(x, y, 2) == 180 && r > 0.8) std::fill_n(&plate.rgba.at(x, y), 3, 35);
    }
  const Result<Segmentation> outlined = segment_drawing(plate);
  ASSERT_TRUE(outlined.ok()) << to_string(outlined.error());
  EXPECT_NE(outlined->labels.at(110, 302), 0) << "a plate";
}

}  // namespace
}  // namespace relievo::understanding

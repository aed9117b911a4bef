#include "io/scribbles/scribble_image.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "understanding/labels/stroke_pixels.h"

namespace relievo {
namespace {

using Colour = std::array<uint8_t, 4>;

void fill(Image8& image, int x0, int y0, int x1, int y1, Colour colour) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      for (int c = 0; c < 4; ++c) image.at(x, y, c) = colour[c];
}

TEST(ScribbleImage, ColoursBecomeParts) {
  Image8 image(60, 40, 4, 255);
  fill(image, 5, 5, 15, 9, {255, 128, 0, 255});
  fill(image, 20, 5, 30, 9, {0, 0, 255, 128});
  fill(image, 35, 5, 45, 9, {0, 0, 0, 255});
  fill(image, 5, 20, 15, 24, {128, 128, 128, 255});
  fill(image, 20, 20, 30, 24, {255, 0, 255, 30});
  const Result<understanding::Scribbles> s = scribbles_from_image(image, 60, 40);
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->parts, (std::vector<std::string>{"#ff8000", "#0000ff"}));
  ASSERT_EQ(s->strokes.size(), 4U);
  EXPECT_EQ(s->strokes[0].kind, understanding::ScribbleKind::hard);
  EXPECT_EQ(s->strokes[1].kind, understanding::ScribbleKind::soft);
  EXPECT_EQ(s->strokes[1].part, 1);
  EXPECT_EQ(s->strokes[2].kind, understanding::ScribbleKind::outside);
  EXPECT_EQ(s->strokes[3].kind, understanding::ScribbleKind::hole);
}

TEST(ScribbleImage, StrokesCoverExactlyTheirPixels) {
  Image8 image(50, 50, 4, 255);
  const Colour green = {0, 200, 0, 255};
  fill(image, 10, 10, 40, 14, green);
  fill(image, 10, 10, 14, 40, green);
  fill(image, 30, 10, 35, 30, green);
  fill(image, 20, 27, 35, 31, green);
  const Result<understanding::Scribbles> s = scribbles_from_image(image, 50, 50);
  ASSERT_TRUE(s.ok());
  ASSERT_EQ(s->strokes.size(), 1U);
  std::set<int32_t> covered;
  for (const understanding::StrokePixel& mark : understanding::stroke_pixels(*s, 50, 50))
    covered.insert(mark.pixel);
  for (int32_t i = 0; i < 2500; ++i)
    EXPECT_EQ(covered.count(i) > 0, image.pixels[4 * i + 1] == 200) << i % 50 << ", " << i / 50;
}

TEST(ScribbleImage, BlendedRimsSayNothing) {
  Image8 image(40, 20, 4, 255);
  fill(image, 5, 5, 30, 10, {200, 0, 0, 255});
  fill(image, 5, 4, 30, 5, {227, 128, 128, 255});
  const Result<understanding::Scribbles> s = scribbles_from_image(image, 40, 20);
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->parts, (std::vector<std::string>{"#c80000"}));
}

TEST(ScribbleImage, SaysWhatIsWrong) {
  EXPECT_EQ(scribbles_from_image(Image8(9, 9, 4, 255), 9, 9).error().code, ErrorCode::bad_input);
  const Result<understanding::Scribbles> other_size =
      scribbles_from_image(Image8(9, 9, 4, 255), 9, 8);
  ASSERT_FALSE(other_size.ok());
  EXPECT_NE(other_size.error().message.find("9 x 8"), std::string::npos);
}

}  // namespace
}  // namespace relievo

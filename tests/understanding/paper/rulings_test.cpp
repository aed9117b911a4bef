#include "understanding/paper/rulings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "support/ink_drawing.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

/// Ruled paper with bluish lines of `width` px, under a drawing.
struct Paper {
  double spacing;
  double slope;
  double width = 1.5;
  int darkest = 70;  ///< of 255, in red
  bool squared = false;

  Drawing under(const InkDrawing& ink) const {
    Drawing drawing = ink.drawing();
    for (int y = 0; y < drawing.rgba.height; ++y)
      for (int x = 0; x < drawing.rgba.width; ++x) {
        const double cover =
            std::max(cover_of(y - slope * x), squared ? cover_of(x + slope * y) : 0.0);
        for (int c = 0; c < 3; ++c) {
          uint8_t& value = drawing.rgba.at(x, y, c);
          value = static_cast<uint8_t>(value * (1 - cover * darkest / (c + 1.0) / 255));
        }
      }
    return drawing;
  }

 private:
  double cover_of(double across) const {
    const double from_line = std::abs(std::remainder(across - 5, spacing));
    return std::clamp(width / 2 + 0.5 - from_line, 0.0, 1.0);
  }
};

InkDrawing waving_snowman() {
  InkDrawing ink(500, 600);
  ink.arc({250, 180}, 90, 0.36, 1.14, 5).circle({250, 380}, 140, 5);
  return ink.line({150, 300}, {60, 220}, 5).line({350, 300}, {440, 220}, 5);
}

const Paper papers[] = {{36, 0.02},
                        {60, -0.04, 2.5},
                        {24, 0, 1, 40},
                        {30, 0.03, 2, 90, true},
                        {48, -0.015, 1.5, 60, true}};

TEST(Rulings, AreRemovedAndTheDrawingStays) {
  const Image8 plain = waving_snowman().drawing().rgba;
  for (const Paper& paper : papers) {
    const Image8 ruled = paper.under(waving_snowman()).rgba;
    const Image8 found = without_rulings(ruled);
    ASSERT_FALSE(found.empty()) << paper.spacing;
    double before = 0;
    double after = 0;
    for (size_t i = 0; i < plain.pixels.size(); ++i) {
      before += std::abs(ruled.pixels[i] - plain.pixels[i]);
      after += std::abs(found.pixels[i] - plain.pixels[i]);
    }
    EXPECT_LT(after, 0.1 * before) << paper.spacing;
  }
}

TEST(Rulings, DoNotChangeTheParts) {
  const Result<Segmentation> plain = segment_drawing(waving_snowman().drawing());
  ASSERT_TRUE(plain.ok());
  for (const Paper& paper : papers) {
    const Result<Segmentation> ruled = segment_drawing(paper.under(waving_snowman()));
    ASSERT_TRUE(ruled.ok()) << to_string(ruled.error());
    EXPECT_EQ(ruled->parts.size(), plain->parts.size()) << paper.spacing;
    int64_t differ = 0;
    for (size_t i = 0; i < plain->labels.pixels.size(); ++i)
      differ += (plain->labels.pixels[i] != 0) != (ruled->labels.pixels[i] != 0) ? 1 : 0;
    EXPECT_LT(differ, 0.01 * static_cast<double>(plain->labels.pixels.size())) << paper.spacing;
  }
}

TEST(Rulings, AreTheSameOnAPageThatLiesOnItsSide) {
  const auto turned = [](const Image8& image) {
    Image8 out(image.height, image.width, image.channels);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        for (int c = 0; c < image.channels; ++c) out.at(y, x, c) = image.at(x, y, c);
    return out;
  };
  const Image8 ruled = Paper{36, 0.02}.under(waving_snowman()).rgba;
  EXPECT_EQ(turned(without_rulings(ruled)).pixels, without_rulings(turned(ruled)).pixels);
}

TEST(Rulings, LinesOfADrawingAreNone) {
  EXPECT_TRUE(without_rulings(waving_snowman().drawing().rgba).empty());
  InkDrawing few = waving_snowman();
  for (const double y : {100.0, 200.0, 300.0, 400.0}) few.line({0, y}, {500, y}, 2);
  EXPECT_TRUE(without_rulings(few.drawing().rgba).empty());
  InkDrawing shirt = waving_snowman();
  for (double y = 280; y < 500; y += 20) shirt.line({140, y}, {360, y}, 2);
  EXPECT_TRUE(without_rulings(shirt.drawing().rgba).empty());
  InkDrawing scattered = waving_snowman();
  for (const double y : {40.0, 70.0, 170.0, 188.0, 310.0, 400.0, 415.0, 560.0})
    scattered.line({0, y}, {500, y}, 2);
  EXPECT_TRUE(without_rulings(scattered.drawing().rgba).empty());
}

}  // namespace
}  // namespace relievo::understanding

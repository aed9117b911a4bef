#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/image/diffusion.h"

namespace relievo {
namespace {

constexpr int columns = 37;
constexpr int rows = 23;

/// Makes an image of two colours, known in a left and a right stripe.
ImageF stripes(float left, float right) {
  ImageF image(columns, rows, 2);
  for (int y = 0; y < rows; ++y)
    for (const int x : {0, 1, columns - 2, columns - 1}) {
      image.at(x, y, 0) = x < columns / 2 ? left : right;
      image.at(x, y, 1) = 1;
    }
  return image;
}

TEST(PullPush, OneColourGoesOnEverywhere) {
  const ImageF filled = pull_push(stripes(40, 40));
  ASSERT_EQ(filled.channels, 1);
  for (const float value : filled.pixels) EXPECT_FLOAT_EQ(value, 40);
}

TEST(PullPush, KeepsWhatIsKnownAndStaysBetween) {
  const ImageF filled = pull_push(stripes(0, 100));
  for (int y = 0; y < rows; ++y) {
    EXPECT_EQ(filled.at(1, y), 0);
    EXPECT_EQ(filled.at(columns - 2, y), 100);
    for (int x = 0; x < columns; ++x) {
      EXPECT_GE(filled.at(x, y), 0);
      EXPECT_LE(filled.at(x, y), 100);
    }
    EXPECT_LT(filled.at(6, y), 50);
    EXPECT_GT(filled.at(columns - 7, y), 50);
  }
}

TEST(PullPush, NothingKnownStaysZero) {
  const ImageF filled = pull_push(ImageF(5, 4, 4));
  EXPECT_TRUE(std::all_of(filled.pixels.begin(), filled.pixels.end(),
                          [](float value) { return value == 0; }));
}

}  // namespace
}  // namespace relievo

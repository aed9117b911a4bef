#include "kernel/image/pull_push.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace relievo {
namespace {

constexpr int width = 37;
constexpr int height = 23;

/// Two colours, known in a left and a right stripe.
ImageF stripes(float left, float right) {
  ImageF image(width, height, 2);
  for (int y = 0; y < height; ++y)
    for (const int x : {0, 1, width - 2, width - 1}) {
      image.at(x, y, 0) = x < width / 2 ? left : right;
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
  for (int y = 0; y < height; ++y) {
    EXPECT_EQ(filled.at(1, y), 0);
    EXPECT_EQ(filled.at(width - 2, y), 100);
    for (int x = 0; x < width; ++x) {
      EXPECT_GE(filled.at(x, y), 0);
      EXPECT_LE(filled.at(x, y), 100);
    }
    EXPECT_LT(filled.at(6, y), 50);
    EXPECT_GT(filled.at(width - 7, y), 50);
  }
}

TEST(PullPush, NothingKnownStaysZero) {
  const ImageF filled = pull_push(ImageF(5, 4, 4));
  EXPECT_TRUE(std::all_of(filled.pixels.begin(), filled.pixels.end(),
                          [](float value) { return value == 0; }));
}

}  // namespace
}  // namespace relievo

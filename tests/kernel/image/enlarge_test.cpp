#include "kernel/image/enlarge.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

TEST(Enlarged, EachPixelBecomesASquare) {
  Image16 image(5, 3, 2);
  for (size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<uint16_t>(7 * i);
  for (int times = 1; times <= 4; ++times) {
    const Image16 large = enlarged(image, times);
    ASSERT_EQ(large.width, 5 * times);
    ASSERT_EQ(large.height, 3 * times);
    for (int y = 0; y < large.height; ++y)
      for (int x = 0; x < large.width; ++x)
        for (int c = 0; c < 2; ++c)
          ASSERT_EQ(large.at(x, y, c), image.at(x / times, y / times, c)) << times;
  }
}

TEST(Enlargement, IsTheLeastThatMakesAPictureLargeEnough) {
  EXPECT_EQ(enlargement(24, 20), 13);
  for (int side = 1; side < 1000; ++side) {
    const int times = enlargement(1 + side / 2, side);
    EXPECT_GE(times * side, small_side);
    EXPECT_TRUE(times == 1 || (times - 1) * side < small_side) << side;
  }
}

}  // namespace
}  // namespace relievo

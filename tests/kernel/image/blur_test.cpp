#include "kernel/image/blur.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_image.h"

namespace relievo {
namespace {

/// Computes the rounded means over the windows of rows.
Image8 blurred_rows(const Image8& image, int radius) {
  Image8 result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < image.channels; ++c) {
        int sum = 0;
        for (int u = x - radius; u <= x + radius; ++u)
          sum += image.at(std::clamp(u, 0, image.width - 1), y, c);
        result.at(x, y, c) =
            static_cast<uint8_t>((2 * sum + 2 * radius + 1) / (2 * (2 * radius + 1)));
      }
  return result;
}

TEST(Blur, BoxIsTheMeanOfRowsAndThenOfColumns) {
  for (const int channels : {1, 3})
    for (const int radius : {1, 2, 7, 8, 30})
      for (const double density : {0.7, 1.0}) {
        const Image8 image = random_image(23, 17, density, 3, channels);
        const Image8 rows = blurred_rows(image, radius);
        const Image8 expected = turned(turned(turned(blurred_rows(turned(rows), radius))));
        EXPECT_EQ(box_blur(image, radius).pixels, expected.pixels) << radius;
      }
}

TEST(Blur, ConstantsStay) {
  const Image8 image(40, 30, 2, 137);
  EXPECT_EQ(box_blur(image, 3).pixels, image.pixels);
  for (const uint8_t value : shrink(image, 7).pixels) EXPECT_EQ(value, 137);
}

TEST(Blur, ShrinkTakesMeansOfBlocks) {
  Image8 image(5, 3, 1);
  image.at(0, 0) = 100;
  image.at(1, 1) = 60;
  image.at(4, 2) = 9;
  const Image8 small = shrink(image, 2);
  ASSERT_EQ(small.width, 3);
  ASSERT_EQ(small.height, 2);
  EXPECT_EQ(small.pixels, (std::vector<uint8_t>{40, 0, 0, 0, 0, 9}));
}

}  // namespace
}  // namespace relievo

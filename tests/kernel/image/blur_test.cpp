#include "kernel/image/blur.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_image.h"

namespace relievo {
namespace {

TEST(Blur, BoxIsTheMeanOfTheSquare) {
  for (const int channels : {1, 3})
    for (const int radius : {1, 2, 7, 30}) {
      const Image8 image = random_image(23, 17, 0.7, 3, channels);
      const Image8 blurred = box_blur(image, radius);
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
          for (int c = 0; c < channels; ++c) {
            double sum = 0;
            for (int v = -radius; v <= radius; ++v)
              for (int u = -radius; u <= radius; ++u)
                sum += image.at(std::clamp(x + u, 0, image.width - 1),
                                std::clamp(y + v, 0, image.height - 1), c);
            // Rows and columns are rounded one after the other.
            EXPECT_NEAR(blurred.at(x, y, c), sum / std::pow(2 * radius + 1, 2), 1.01);
          }
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

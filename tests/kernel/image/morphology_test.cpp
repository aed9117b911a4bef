#include "kernel/image/morphology.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/image/components.h"
#include "support/random_image.h"

namespace relievo {
namespace {

TEST(Morphology, FiltersTakeTheExtremesOfTheSquare) {
  for (const int radius : {1, 2, 5, 9, 40})
    for (const int height : {1, 7, 19, 22}) {
      const Image8 image = random_image(23, height, 0.4, static_cast<uint32_t>(radius), 2);
      const Image8 high = max_filter(image, radius);
      const Image8 low = min_filter(image, radius);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < image.width; ++x)
          for (int c = 0; c < 2; ++c) {
            uint8_t largest = 0;
            uint8_t smallest = 255;
            for (int v = std::max(0, y - radius); v <= std::min(height - 1, y + radius); ++v)
              for (int u = std::max(0, x - radius); u <= std::min(22, x + radius); ++u) {
                largest = std::max(largest, image.at(u, v, c));
                smallest = std::min(smallest, image.at(u, v, c));
              }
            ASSERT_EQ(high.at(x, y, c), largest) << radius << ": " << x << ", " << y;
            ASSERT_EQ(low.at(x, y, c), smallest) << radius << ": " << x << ", " << y;
          }
    }
}

TEST(Morphology, ClosingRemovesNarrowDarkLinesOnly) {
  Image8 image(60, 40, 1, 200);
  for (int y = 0; y < 40; ++y) {
    for (int x = 10; x < 13; ++x) image.at(x, y) = 20;
    for (int x = 30; x < 50; ++x) image.at(x, y) = 50;
  }
  const Image8 closed = close_gaps(image, 3);
  EXPECT_EQ(closed.at(11, 20), 200);
  for (int x = 30; x < 50; ++x) EXPECT_EQ(closed.at(x, 20), 50);
  for (size_t i = 0; i < image.pixels.size(); ++i) EXPECT_GE(closed.pixels[i], image.pixels[i]);
}

TEST(Morphology, ThinningKeepsPiecesHolesAndEnds) {
  Image8 mask(80, 60, 1);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) {
      const int r2 = (x - 25) * (x - 25) + (y - 30) * (y - 30);
      const bool ring = r2 <= 400 && r2 >= 225;
      const bool bar = x >= 50 && x < 78 && y >= 28 && y < 33;
      mask.at(x, y) = ring || bar ? 1 : 0;
    }
  const Image8 thinned = thin(mask);
  EXPECT_EQ(connected_components(thinned, Connectivity::corners).areas.size(), 3U);
  Image8 outside = thinned;
  for (uint8_t& value : outside.pixels) value = value == 0 ? 1 : 0;
  EXPECT_EQ(connected_components(outside, Connectivity::sides).areas.size(), 3U);
  int bar_length = 0;
  for (int x = 50; x < 80; ++x)
    for (int y = 0; y < 60; ++y) bar_length += thinned.at(x, y) != 0 ? 1 : 0;
  EXPECT_GE(bar_length, 28 - 5);
  for (int y = 0; y + 1 < 60; ++y)
    for (int x = 0; x + 1 < 80; ++x) {
      const bool block = thinned.at(x, y) != 0 && thinned.at(x + 1, y) != 0 &&
                         thinned.at(x, y + 1) != 0 && thinned.at(x + 1, y + 1) != 0;
      EXPECT_FALSE(block) << x << ", " << y;
    }
}

}  // namespace
}  // namespace relievo

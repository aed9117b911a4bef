#include "kernel/image/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_image.h"

namespace relievo {
namespace {

int32_t nearest(const Image8& mask, int x, int y) {
  int32_t best = no_distance;
  for (int v = 0; v < mask.height; ++v)
    for (int u = 0; u < mask.width; ++u)
      if (mask.at(u, v) != 0) best = std::min(best, (u - x) * (u - x) + (v - y) * (v - y));
  return best;
}

TEST(DistanceTransform, EqualsTheNearestOfAllPixels) {
  for (uint32_t seed = 0; seed < 60; ++seed) {
    const Image8 mask =
        random_image(1 + static_cast<int>(seed * 7 % 31), 1 + static_cast<int>(seed * 5 % 23),
                     seed % 3 == 0 ? 0.01 : 0.1, seed);
    const Image<int32_t> distance = squared_distance_to(mask);
    for (int y = 0; y < mask.height; ++y)
      for (int x = 0; x < mask.width; ++x)
        ASSERT_EQ(distance.at(x, y), nearest(mask, x, y)) << seed << ": " << x << ", " << y;
  }
}

TEST(DistanceTransform, SaysSoWhereNothingIsNear) {
  for (const int32_t distance : squared_distance_to(Image8(5, 4, 1)).pixels)
    EXPECT_EQ(distance, no_distance);
}

TEST(DistanceTransform, LongSidesDoNotOverflow) {
  Image8 mask(32767, 2, 1);
  mask.at(0, 0) = 1;
  EXPECT_EQ(squared_distance_to(mask).at(32766, 1), 32766 * 32766 + 1);
}

}  // namespace
}  // namespace relievo

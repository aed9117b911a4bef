#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/image/enlarge.h"
#include "relievo/pixel_art.h"

namespace relievo {
namespace {

using Rgba = std::array<uint8_t, 4>;

void set(Image8& image, int x, int y, Rgba colour) {
  std::copy(colour.begin(), colour.end(), &image.at(x, y));
}

/// How much of a pixel lies in a ball whose middle is at 0.47 of the picture, by samples a side.
double cover(int side, double radius, int x, int y, int samples) {
  int inside = 0;
  for (int v = 0; v < samples; ++v)
    for (int u = 0; u < samples; ++u)
      inside += std::hypot(x + (u + 0.5) / samples - 0.47 * side,
                           y + (v + 0.5) / samples - 0.47 * side) < radius * side
                    ? 1
                    : 0;
  return static_cast<double>(inside) / (samples * samples);
}

/// A ball with a nose. With one sample a pixel its steps are hard, with more they are smooth.
Image8 ball(int side, int samples) {
  Image8 image(side, side, 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double skin = cover(side, 0.4, x, y, samples);
      const double nose = cover(side, 0.15, x, y, samples);
      const auto mix = [nose](double a, double b) {
        return static_cast<uint8_t>(std::lround(a + nose * (b - a)));
      };
      set(image, x, y,
          {mix(240, 180), mix(170, 30), mix(60, 40),
           static_cast<uint8_t>(std::lround(255 * skin))});
    }
  return image;
}

TEST(OwnPixels, HardStepsMakePixelArtAndSmoothOnesDoNot) {
  for (int side = 16; side < small_side; side += 13) {
    EXPECT_EQ(own_pixels(ball(side, 1)), 1) << side;
    EXPECT_EQ(own_pixels(ball(side, 8)), 0) << side;
  }
}

TEST(OwnPixels, EnlargedPixelArtHasLargerOnes) {
  for (int times = 2; times < 40; times += 3) {
    EXPECT_EQ(own_pixels(enlarged(ball(24, 1), times)), times);
    EXPECT_EQ(own_pixels(enlarged(ball(24, 8), times)), 0) << times;
  }
}

TEST(OwnPixels, LargePicturesHaveThemOnlyWhenTold) {
  const Image8 large = ball(small_side, 1);
  EXPECT_EQ(own_pixels(large), 0);
  EXPECT_EQ(own_pixels(large, true), 1);
  EXPECT_EQ(own_pixels(enlarged(large, 2), true), 2);
  EXPECT_EQ(own_pixels(ball(24, 1), false), 0);
  EXPECT_EQ(own_pixels({}, true), 0);
}

TEST(OwnPixels, PhotographsAndPlainPicturesHaveNone) {
  Image8 noise(64, 48, 4, 255);
  uint32_t random = 1;
  for (size_t i = 0; i < noise.pixels.size(); ++i)
    if (i % 4 != 3) noise.pixels[i] = static_cast<uint8_t>((random = random * 69069 + 1) >> 24);
  EXPECT_EQ(own_pixels(noise), 0);
  EXPECT_EQ(own_pixels(Image8(32, 32, 4, 90)), 0);
}

TEST(OwnPixels, WhatIsTransparentHasNoColour) {
  Image8 image = ball(24, 1);
  for (size_t i = 0; i < image.pixels.size(); i += 4)
    if (image.pixels[i + 3] == 0) image.pixels[i] = static_cast<uint8_t>(i);
  EXPECT_EQ(own_pixels(image), 1);
}

TEST(MapSide, IsTheLargestMultipleOfThePixelArtsSize) {
  for (int own = 1; own < 400; own += 7) {
    const Drawing art{Image8(3 * own, 2 * own, 4), own % 3 == 0 ? 3 : 1};
    const int size = 3 * own / art.pixel_art;
    const int side = map_side(art, 300);
    EXPECT_EQ(side % size, 0);
    EXPECT_GT(side + size, 300);
    EXPECT_LE(side, std::max(300, size));
  }
  EXPECT_EQ(map_side({Image8(24, 24, 4)}, 300), 300);
}

}  // namespace
}  // namespace relievo

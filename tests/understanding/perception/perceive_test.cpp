#include "understanding/perception/perceive.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "kernel/image/enlarge.h"
#include "support/ink_drawing.h"
#include "understanding/perception/built_in_network.h"

namespace relievo::understanding {
namespace {

/// The mean of a map, of 255, over the cells for which `counts` holds; it takes a point in px.
template <class Counts>
double mean_where(const Image8& map, double cell, Counts counts) {
  double sum = 0;
  double cells = 0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      if (!counts(Point2{(x + 0.5) * cell, (y + 0.5) * cell})) continue;
      sum += map.at(x, y) / 255.0;
      ++cells;
    }
  return sum / cells;
}

/// A body and a head before it.
Drawing snowman() {
  InkDrawing ink(500, 640);
  ink.disc({250, 420}, 160, 90, 140, 220).disc({250, 200}, 110, 240, 200, 90);
  return ink.circle({250, 200}, 110).drawing();
}

TEST(Perceive, SeesTheFigureItsContoursAndItsOrder) {
  const auto seen = perceive(snowman().rgba, built_in_network());
  ASSERT_TRUE(seen);
  const auto outside = [](Point2 p) {
    return std::min(distance(p, {250, 420}) - 160, distance(p, {250, 200}) - 110);
  };
  const double cell = seen->cell;
  EXPECT_GT(mean_where(seen->figure, cell, [&](Point2 p) { return outside(p) < -8; }), 0.9);
  EXPECT_LT(mean_where(seen->figure, cell, [&](Point2 p) { return outside(p) > 8; }), 0.1);
  const auto from_head = [](Point2 p) { return std::abs(distance(p, {250, 200}) - 110); };
  EXPECT_GT(mean_where(seen->contour, cell, [&](Point2 p) { return from_head(p) < 2; }), 0.6);
  EXPECT_LT(mean_where(seen->contour, cell,
                       [&](Point2 p) {
                         return distance(p, {250, 480}) < 60;
                       }),
            0.1);
  // The chin lies before the body.
  const ImageF& way = seen->front.way;
  EXPECT_LT(way.at(static_cast<int>(250 / cell), static_cast<int>(310 / cell), 1), 0);
}

TEST(Perceive, CoversSmallAndLargePictures) {
  for (const auto& [width, height] : {std::array{37, 20}, std::array{500, 640}, {1500, 300}}) {
    const auto seen = perceive(Image8(width, height, 4, 255), built_in_network());
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->figure.width * seen->cell, width, 2 * seen->cell);
    EXPECT_NEAR(seen->figure.height * seen->cell, height, 2 * seen->cell);
    EXPECT_LE(seen->figure.width, 256);
    EXPECT_LE(seen->figure.height, 256);
  }
}

TEST(Perceive, SeesEnlargedPixelsAsTheyWere) {
  const Image8 small = InkDrawing(60, 40).disc({25, 20}, 15, 90, 140, 220).drawing().rgba;
  const auto seen = perceive(small, built_in_network());
  const auto large = perceive(enlarged(small, 5), built_in_network());
  ASSERT_TRUE(seen && large);
  EXPECT_EQ(large->figure.pixels, seen->figure.pixels);
  EXPECT_DOUBLE_EQ(large->cell, 5 * seen->cell);
}

TEST(Perceive, InterpolatesLinearly) {
  Image8 ramp(20, 10, 1);
  for (int y = 0; y < ramp.height; ++y)
    for (int x = 0; x < ramp.width; ++x) ramp.at(x, y) = static_cast<uint8_t>(6 * x + 4 * y);
  const double cell = 4.5;
  const Image8 pixels = at_pixels(ramp, cell, 90, 45);
  for (int y = 3; y < 42; ++y)
    for (int x = 3; x < 87; ++x)
      EXPECT_NEAR(pixels.at(x, y), 6 * ((x + 0.5) / cell - 0.5) + 4 * ((y + 0.5) / cell - 0.5), 1);
}

}  // namespace
}  // namespace relievo::understanding

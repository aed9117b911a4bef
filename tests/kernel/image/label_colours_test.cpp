#include <gtest/gtest.h>

#include "kernel/image/compose.h"

namespace relievo {
namespace {

Image8 filled(int width, int height, const std::array<uint8_t, 4>& colour) {
  Image8 rgba(width, height, 4);
  for (size_t i = 0; i < rgba.pixels.size(); ++i) rgba.pixels[i] = colour[i % 4];
  return rgba;
}

TEST(LabelColours, AreThoseOfThePaintWithoutTheLinesAround) {
  Image8 rgba = filled(40, 20, {200, 100, 50, 255});
  Image16 labels(40, 20, 1, 2);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x) {
      if (x >= 20) labels.at(x, y) = 1;
      const bool line = x == 19 || x == 20;
      for (int c = 0; c < 3 && line; ++c) rgba.at(x, y, c) = 0;
    }
  const auto colours = label_colours(rgba, labels);
  ASSERT_EQ(colours.size(), 3U);
  EXPECT_EQ(colours[1], (std::array<double, 3>{200, 100, 50}));
  EXPECT_EQ(colours[2], colours[1]);
}

TEST(LabelColours, TransparentPaintLiesOnWhiteAndThinPartsCountWhole) {
  const Image8 rgba = filled(9, 9, {0, 0, 0, 51});
  Image16 labels(9, 9, 1, 1);
  for (int x = 0; x < 9; ++x) labels.at(x, 4) = 4;
  const auto colours = label_colours(rgba, labels);
  ASSERT_EQ(colours.size(), 5U);
  for (const size_t label : {1, 4})
    for (const double channel : colours[label]) EXPECT_NEAR(channel, 204, 1e-9);
  EXPECT_EQ(colours[3], (std::array<double, 3>{0, 0, 0})) << "no pixel has this label";
}

}  // namespace
}  // namespace relievo

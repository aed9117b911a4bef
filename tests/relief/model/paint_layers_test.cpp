#include "relief/model/paint_layers.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

const Outline body = {{{10, 10}, {50, 10}, {50, 50}, {10, 50}}};
const Outline hand = {{{30, 30}, {70, 30}, {70, 70}, {30, 70}}};

/// A red square below a blue one with a black outline, twice as many pixels a side as the canvas.
Image8 drawing() {
  Image8 rgba(160, 160, 4, 255);
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      const bool in_hand = x >= 60 && y >= 60 && x < 140 && y < 140;
      const bool in_body = x >= 20 && y >= 20 && x < 100 && y < 100;
      const bool ink = in_hand && (x < 62 || y < 62 || x >= 138 || y >= 138);
      for (int c = 0; c < 3; ++c)
        rgba.at(x, y, c) = static_cast<uint8_t>(ink       ? 0
                                                : in_hand ? 60 * c + 80
                                                : in_body ? 200 - 60 * c
                                                          : 255);
    }
  return rgba;
}

TEST(PaintLayers, GiveTheDrawingFromTheFrontAndOwnColoursBehind) {
  Scene scene;
  scene.width = scene.height = 80;
  scene.parts = {Part{"body", body}, Part{"hand", hand}};
  const Image8 rgba = drawing();
  const auto layers = paint_layers(scene, rgba);
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[0].name, "body");
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      const Image8& seen = layers[layers[1].rgba.at(x, y, 3) > 0 ? 1 : 0].rgba;
      if (seen.at(x, y, 3) == 0) continue;
      for (int c = 0; c < 4; ++c) ASSERT_EQ(seen.at(x, y, c), rgba.at(x, y, c));
    }
  // Behind the hand the body is red, without the hand's ink.
  EXPECT_EQ(layers[0].rgba.at(80, 80, 3), 255);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(layers[0].rgba.at(80, 80, c), 200 - 60 * c, 1);
  EXPECT_EQ(layers[0].rgba.at(120, 120, 3), 0);
}

}  // namespace
}  // namespace relievo

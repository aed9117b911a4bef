#include "relief/finish/paint_layers.h"

#include <gtest/gtest.h>

namespace relievo::relief {
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

/// The layer's pixel at a place of the drawing, nullptr outside the layer.
const uint8_t* pixel(const PaintedLayer& layer, int x, int y) {
  const int u = x - layer.left;
  const int v = y - layer.top;
  const bool holds = u >= 0 && v >= 0 && u < layer.rgba.width && v < layer.rgba.height;
  return holds ? &layer.rgba.at(u, v) : nullptr;
}

bool is_painted(const uint8_t* pixel) { return pixel != nullptr && pixel[3] > 0; }

TEST(PaintLayers, GiveTheDrawingFromTheFrontAndOwnColoursBehind) {
  Scene scene;
  scene.width = scene.height = 80;
  scene.parts = {Part{"body", body}, Part{"hand", hand}};
  const Image8 rgba = drawing();
  const auto layers = paint_layers(scene, {rgba});
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[0].name, "body");
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      const uint8_t* hand_pixel = pixel(layers[1], x, y);
      const uint8_t* seen = is_painted(hand_pixel) ? hand_pixel : pixel(layers[0], x, y);
      const bool in_parts =
          (x >= 60 && y >= 60 && x < 140 && y < 140) || (x >= 20 && y >= 20 && x < 100 && y < 100);
      ASSERT_EQ(is_painted(seen), in_parts);
      for (int c = 0; in_parts && c < 4; ++c) ASSERT_EQ(seen[c], rgba.at(x, y, c));
    }
  // Behind the hand the body is red, without the hand's ink.
  const uint8_t* hidden = pixel(layers[0], 80, 80);
  ASSERT_TRUE(is_painted(hidden));
  EXPECT_EQ(hidden[3], 255);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(hidden[c], 200 - 60 * c, 1);
}

}  // namespace
}  // namespace relievo::relief

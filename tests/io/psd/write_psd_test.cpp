#include "io/psd/write_psd.h"

#include <gtest/gtest.h>

#include <random>

#include "io/psd/psd_file.h"

namespace relievo {
namespace {

/// Noise, runs and gradients, transparent around a box.
Image8 motley(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image8 rgba(width, height, 4);
  for (int y = 3; y < height - 2; ++y)
    for (int x = 5; x < width - 4; ++x) {
      for (int c = 0; c < 3; ++c)
        rgba.at(x, y, c) = static_cast<uint8_t>(y % 3 == 0   ? random() % 256
                                                : y % 3 == 1 ? 40 * c
                                                             : x + c);
      rgba.at(x, y, 3) = static_cast<uint8_t>(y % 4 == 0 ? 100 + seed : 255);
    }
  return rgba;
}

TEST(WritePsd, LayersComeBackAsTheyWere) {
  const Image8 below = motley(300, 60, 1);
  const Image8 above = motley(300, 60, 2);
  const auto bytes =
      encode_psd({{"drawing", &below, 0, 0, true}, {"Körper \xf0\x9f\x90\xba", &above}}, 300, 60);
  ASSERT_TRUE(bytes);
  const auto file = read_psd_file(*bytes, {});
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->layers.size(), 2U);
  EXPECT_TRUE(file->layers[0].hidden);
  EXPECT_FALSE(file->layers[1].hidden);
  EXPECT_EQ(file->layers[1].name, "Körper \xf0\x9f\x90\xba");
  const PsdLayer& layer = file->layers[1];
  EXPECT_EQ(layer.box.left, 5);
  EXPECT_EQ(layer.box.bottom, 58);
  ASSERT_EQ(layer.channels.size(), 4U);
  for (const PsdChannel& channel : layer.channels) {
    const auto plane = decode_channel(channel.data, layer.box.width(), layer.box.height(), 8);
    ASSERT_TRUE(plane);
    size_t i = 0;
    for (int y = layer.box.top; y < layer.box.bottom; ++y)
      for (int x = layer.box.left; x < layer.box.right; ++x)
        ASSERT_EQ((*plane)[i++], above.at(x, y, channel.id < 0 ? 3 : channel.id));
  }
  const auto merged = decode_merged(file->merged, 4, 300, 60, 8);
  ASSERT_TRUE(merged);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 300; ++x) {
      ASSERT_EQ((*merged)[3][300 * y + x], above.at(x, y, 3));
      if (above.at(x, y, 3) > 0) {
        ASSERT_EQ((*merged)[1][300 * y + x], above.at(x, y, 1));
      }
    }
}

TEST(WritePsd, LaysALayerWhereItBelongs) {
  Image8 dot(2, 1, 4, 255);
  dot.at(1, 0, 3) = 0;
  const auto bytes = encode_psd({{"dot", &dot, 7, 4}}, 20, 10);
  ASSERT_TRUE(bytes);
  const auto file = read_psd_file(*bytes, {});
  ASSERT_TRUE(file) << file.error().message;
  const PixelBox& box = file->layers[0].box;
  EXPECT_EQ(box.left, 7);
  EXPECT_EQ(box.right, 8);
  EXPECT_EQ(box.top, 4);
  EXPECT_EQ(box.bottom, 5);
  const auto merged = decode_merged(file->merged, 4, 20, 10, 8);
  ASSERT_TRUE(merged);
  for (int i = 0; i < 200; ++i) EXPECT_EQ((*merged)[3][i], i == 4 * 20 + 7 ? 255 : 0);
}

TEST(WritePsd, TakesEmptyLayersAndRefusesWhatTheFormatCannotHold) {
  const Image8 nothing(20, 10, 4);
  const auto bytes = encode_psd({{"", &nothing}}, 20, 10);
  ASSERT_TRUE(bytes);
  const auto file = read_psd_file(*bytes, {});
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_TRUE(file->layers[0].box.empty());
  EXPECT_EQ(encode_psd({}, 30001, 10).error().code, ErrorCode::limit);
}

}  // namespace
}  // namespace relievo

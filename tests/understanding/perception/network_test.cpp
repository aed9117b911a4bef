#include "understanding/perception/network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "io/files/byte_writer.h"
#include "understanding/perception/perceive.h"

namespace relievo::understanding {
namespace {

/// The numbers of a layer in a network's file.
struct LayerFile {
  int inputs = 1;
  int outputs = 1;
  int side = 1;
  int stride = 1;
  int dilation = 1;
  bool clamped = false;
  std::vector<float> scales;
  std::vector<float> bias;
  std::vector<int8_t> weights;  ///< [outputs][taps][inputs]
};

LayerFile random_layer(int inputs, int outputs, int side, int stride, int dilation, bool clamped,
                       std::mt19937& random) {
  LayerFile layer{inputs, outputs, side, stride, dilation, clamped, {}, {}, {}};
  std::uniform_int_distribution<int> weight(-127, 127);
  std::uniform_real_distribution<float> scale(0.001F, 0.01F);
  for (int o = 0; o < outputs; ++o) {
    layer.scales.push_back(scale(random));
    layer.bias.push_back(10 * scale(random));
  }
  for (int k = 0; k < outputs * side * side * inputs; ++k)
    layer.weights.push_back(static_cast<int8_t>(weight(random)));
  return layer;
}

Bytes encode(const std::vector<LayerFile>& layers) {
  Bytes bytes = {'R', 'L', 'V', 'N'};
  append_u32(bytes, static_cast<uint32_t>(layers.size()));
  for (const LayerFile& layer : layers) {
    for (const int value : {layer.inputs, layer.outputs, layer.side, layer.stride, layer.dilation,
                            layer.clamped ? 1 : 0})
      append_u16(bytes, static_cast<uint16_t>(value));
    for (const float scale : layer.scales) append_f32(bytes, scale);
    for (const float bias : layer.bias) append_f32(bytes, bias);
    for (const int8_t weight : layer.weights) bytes.push_back(static_cast<uint8_t>(weight));
  }
  return bytes;
}

ImageF random_image(int width, int height, int channels, std::mt19937& random) {
  std::uniform_real_distribution<float> value(-1, 1);
  ImageF image(width, height, channels);
  for (float& v : image.pixels) v = value(random);
  return image;
}

/// Evaluates the equation of NetworkLayer at one pixel and output.
double value_at(const ImageF& image, const LayerFile& layer, int x, int y, int o) {
  double sum = layer.bias[o];
  const int half = layer.side / 2;
  for (int v = 0; v < layer.side; ++v)
    for (int u = 0; u < layer.side; ++u)
      for (int i = 0; i < layer.inputs; ++i) {
        const int px = x * layer.stride + (u - half) * layer.dilation;
        const int py = y * layer.stride + (v - half) * layer.dilation;
        if (px < 0 || py < 0 || px >= image.width || py >= image.height) continue;
        const int k = ((o * layer.side + v) * layer.side + u) * layer.inputs + i;
        sum += double{layer.scales[o]} * layer.weights[k] * image.at(px, py, i);
      }
  return layer.clamped ? std::clamp(sum, 0.0, 6.0) : sum;
}

TEST(Network, ConvolvesAsItsEquationSays) {
  std::mt19937 random(1);
  for (const auto& [side, stride, dilation] :
       {std::array{1, 1, 1}, std::array{3, 1, 1}, std::array{3, 1, 2}, std::array{5, 2, 1}}) {
    const LayerFile file = random_layer(3, 11, side, stride, dilation, side == 3, random);
    const auto network = decode_network(encode({file}));
    ASSERT_TRUE(network);
    const ImageF image = random_image(13, 10, 3, random);
    const ImageF result = convolve(image, network->front());
    ASSERT_EQ(result.width, (13 + stride - 1) / stride);
    ASSERT_EQ(result.height, (10 + stride - 1) / stride);
    for (int y = 0; y < result.height; ++y)
      for (int x = 0; x < result.width; ++x)
        for (int o = 0; o < 11; ++o)
          ASSERT_NEAR(result.at(x, y, o), value_at(image, file, x, y, o), 1e-4);
  }
}

TEST(Network, RefusesDamagedFiles) {
  std::mt19937 random(2);
  const Bytes good = encode({random_layer(2, 3, 3, 1, 1, true, random)});
  ASSERT_TRUE(decode_network(good));
  for (size_t size = 0; size < good.size(); ++size)
    EXPECT_FALSE(decode_network(ByteView(good).first(size))) << size;
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_FALSE(decode_network(longer));
  Bytes even = good;
  even[12] = 2;  // the side of its filters
  EXPECT_FALSE(decode_network(even));
}

TEST(Network, PerceptionNeedsItsLayers) {
  std::mt19937 random(3);
  const auto network = decode_network(encode({random_layer(4, 4, 1, 1, 1, false, random)}));
  ASSERT_TRUE(network);
  const auto seen = perceive(Image8(20, 10, 4, 255), *network);
  ASSERT_FALSE(seen);
  EXPECT_EQ(seen.error().code, ErrorCode::bad_input);
}

}  // namespace
}  // namespace relievo::understanding

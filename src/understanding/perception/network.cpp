#include "understanding/perception/network.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

namespace relievo::understanding {
namespace {

constexpr int block = 8;  ///< outputs that are computed together
constexpr int strip = 4;  ///< pixels of a row that are computed together
constexpr float ceiling = 6;
constexpr int most_channels = 512;
constexpr int widest_side = 7;
constexpr uint32_t most_layers = 64;

/// Reads little-endian numbers; all are 0 once the bytes have ended.
class Reader {
 public:
  explicit Reader(ByteView bytes) : bytes_(bytes) {}

  uint32_t number(int size) {
    uint32_t value = 0;
    for (int k = 0; k < size; ++k) value |= static_cast<uint32_t>(byte()) << (8 * k);
    return value;
  }

  float real() {
    const uint32_t bits = number(4);
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  int8_t weight() { return static_cast<int8_t>(byte()); }
  bool has(size_t count) const { return bytes_.size() - at_ >= count; }
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  uint8_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : uint8_t{0}; }

  ByteView bytes_;
  size_t at_ = 0;
};

int rounded_up(int value, int unit) { return (value + unit - 1) / unit * unit; }

bool is_valid(const NetworkLayer& layer) {
  const auto within = [](int value, int most) { return value >= 1 && value <= most; };
  return within(layer.inputs, most_channels) && within(layer.outputs, most_channels) &&
         within(layer.side, widest_side) && layer.side % 2 == 1 && within(layer.stride, 2) &&
         within(layer.dilation, 8);
}

/// Reads a layer; false where it is damaged.
bool read_layer(Reader& reader, NetworkLayer& layer) {
  for (int* value : {&layer.inputs, &layer.outputs, &layer.side, &layer.stride, &layer.dilation})
    *value = static_cast<int>(reader.number(2));
  layer.clamped = reader.number(2) != 0;
  if (!is_valid(layer)) return false;
  const int taps = layer.side * layer.side;
  const auto per_output = static_cast<size_t>(taps) * layer.inputs;
  if (!reader.has(layer.outputs * (per_output + 8))) return false;
  const int padded = rounded_up(layer.outputs, block);
  std::vector<float> scales(layer.outputs);
  for (float& scale : scales) scale = reader.real();
  layer.bias.assign(padded, 0);
  for (int o = 0; o < layer.outputs; ++o) layer.bias[o] = reader.real();
  layer.weights.assign(padded * per_output, 0);
  for (int o = 0; o < layer.outputs; ++o)
    for (size_t k = 0; k < per_output; ++k)
      layer.weights[((o / block) * per_output + k) * block + o % block] =
          scales[o] * static_cast<float>(reader.weight());
  return true;
}

/// Returns an image with a border of zeros, and more of them at the right, so that strips end
/// inside it.
ImageF with_border(const ImageF& image, int border, int right) {
  ImageF padded(image.width + 2 * border + right, image.height + 2 * border, image.channels);
  const auto row = static_cast<ptrdiff_t>(image.width) * image.channels;
  for (int y = 0; y < image.height; ++y) {
    const auto from = image.pixels.begin() + y * row;
    std::copy(from, from + row, &padded.at(border, y + border));
  }
  return padded;
}

using Block = std::array<float, block>;

/// Adds one tap to the sums of a strip. `in`: first pixel; `step`: floats between pixels.
inline void add_tap(const float* in, ptrdiff_t step, int inputs, const float* weights,
                    std::array<Block, strip>& sums) {
  for (int i = 0; i < inputs; ++i, weights += block)
    for (int p = 0; p < strip; ++p) {
      const float x = in[p * step + i];
      for (int o = 0; o < block; ++o) sums[p][o] += x * weights[o];
    }
}

/// Computes the block `b` of outputs along a row.
void convolve_row(const ImageF& padded, const NetworkLayer& layer, int y, int b, ImageF& result) {
  const int channels = layer.inputs;
  const size_t per_tap = static_cast<size_t>(channels) * block;
  const float* weights = &layer.weights[per_tap * layer.side * layer.side * b];
  const ptrdiff_t step = static_cast<ptrdiff_t>(layer.stride) * channels;
  const int count = std::min(block, layer.outputs - b * block);
  for (int x = 0; x < result.width; x += strip) {
    std::array<Block, strip> sums;
    for (Block& sum : sums) std::copy_n(&layer.bias[b * block], block, sum.begin());
    for (int v = 0, tap = 0; v < layer.side; ++v)
      for (int u = 0; u < layer.side; ++u, ++tap)
        add_tap(&padded.at(x * layer.stride + u * layer.dilation,
                           y * layer.stride + v * layer.dilation),
                step, channels, weights + tap * per_tap, sums);
    for (int p = 0; p < std::min(strip, result.width - x); ++p)
      for (int o = 0; o < count; ++o)
        result.at(x + p, y, b * block + o) =
            layer.clamped ? std::clamp(sums[p][o], 0.0F, ceiling) : sums[p][o];
  }
}

}  // namespace

Result<Network> decode_network(ByteView bytes) {
  const Error damaged{ErrorCode::bad_input, "the weights of the network are damaged", ""};
  constexpr std::string_view magic = "RLVN";
  if (bytes.size() < 8 || !std::equal(magic.begin(), magic.end(), bytes.begin())) return damaged;
  Reader reader(bytes.subspan(magic.size()));
  const uint32_t layers = reader.number(4);
  if (layers > most_layers) return damaged;
  Network network(layers);
  for (NetworkLayer& layer : network)
    if (!read_layer(reader, layer)) return damaged;
  if (!reader.at_end()) return damaged;
  return network;
}

ImageF convolve(const ImageF& image, const NetworkLayer& layer) {
  const int reach = layer.dilation * (layer.side / 2);
  const ImageF padded = with_border(image, reach, strip * layer.stride);
  ImageF result((image.width + layer.stride - 1) / layer.stride,
                (image.height + layer.stride - 1) / layer.stride, layer.outputs);
  for (int y = 0; y < result.height; ++y)
    for (int b = 0; b * block < layer.outputs; ++b) convolve_row(padded, layer, y, b, result);
  return result;
}

}  // namespace relievo::understanding

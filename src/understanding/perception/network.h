#pragma once

#include <vector>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo::understanding {

/// A layer of a convolutional network,
///   y_o(p) = b_o + sum over taps t and channels i of w_oti x_i(stride p + dilation t),
/// clamped to [0, 6] afterwards where `clamped`. x is 0 outside the image.
struct NetworkLayer {
  int inputs = 0;
  int outputs = 0;
  int side = 1;  ///< taps along x and along y, odd
  int stride = 1;
  int dilation = 1;
  bool clamped = true;
  std::vector<float> weights;  ///< [blocks of 8 outputs][taps][inputs][8], 0 beyond the last output
  std::vector<float> bias;     ///< [outputs rounded up to 8]
};

/// The layers of a network, in the order in which they are applied.
using Network = std::vector<NetworkLayer>;

/// Decodes a network. Its file holds little-endian numbers: the bytes "RLVN", the number of layers
/// (32 bits), and for each layer its inputs, outputs, side, stride, dilation and whether it is
/// clamped (16 bits each), a scale and a bias for each output (32-bit floats), and a weight of 8
/// bits [outputs][taps][inputs], to be multiplied by the scale. Errors: `bad_input` where the file
/// is damaged.
Result<Network> decode_network(ByteView bytes);

/// Applies a layer. Precondition: `image` has as many channels as the layer has inputs. The result
/// has ceil(width / stride) x ceil(height / stride) px. Every sum is taken in one order, so that
/// all machines compute the same bits. O(pixels * weights).
ImageF convolve(const ImageF& image, const NetworkLayer& layer);

}  // namespace relievo::understanding

#include "io/layered/layer_color.h"

#include <vector>

#include "io/parts/figures.h"

namespace relievo {
namespace {

/// Width of what is taken for the rim, px.
constexpr int rim_width = 2;

/// Pixels of an image, 1 or 0 each.
using Mask = std::vector<char>;

Mask opaque_pixels(const RasterLayer& layer) {
  Mask mask(layer.rgba.pixels.size() / 4);
  for (size_t i = 0; i < mask.size(); ++i)
    mask[i] = layer.opacity * layer.rgba.pixels[4 * i + 3] >= 127.5 ? 1 : 0;
  return mask;
}

/// The pixels whose four neighbours are all in the mask.
Mask eroded(const Mask& mask, int width, int height) {
  Mask inner(mask.size());
  for (int y = 1; y + 1 < height; ++y)
    for (int x = 1; x + 1 < width; ++x) {
      const size_t i = static_cast<size_t>(y) * width + x;
      inner[i] = mask[i] & mask[i - 1] & mask[i + 1] & mask[i - width] & mask[i + width];
    }
  return inner;
}

struct MeanColor {
  double sum[4] = {0, 0, 0, 0};
  double count = 0;

  void add(const uint8_t* rgba) {
    for (int k = 0; k < 4; ++k) sum[k] += rgba[k] / 255.0;
    ++count;
  }

  Color mean() const { return {sum[0] / count, sum[1] / count, sum[2] / count, sum[3] / count}; }
};

}  // namespace

LayerColor color_of(const RasterLayer& layer) {
  const Mask mask = opaque_pixels(layer);
  Mask core = mask;
  for (int k = 0; k < rim_width; ++k) core = eroded(core, layer.rgba.width, layer.rgba.height);
  MeanColor inner;
  MeanColor rim;
  for (size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) (core[i] ? inner : rim).add(&layer.rgba.pixels[4 * i]);
  LayerColor color;
  if (inner.count == 0) {
    if (rim.count > 0) color.inner = rim.mean();
    color.inner.a *= layer.opacity;
    return color;
  }
  color.inner = inner.mean();
  color.inner.a *= layer.opacity;
  color.outlined = rim.count > 0 && color_distance(color.inner, rim.mean()) > color_contrast;
  return color;
}

}  // namespace relievo

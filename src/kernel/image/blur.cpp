#include "kernel/image/blur.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace relievo {
namespace {

/// Sums of at most 4001 bytes times this, shifted by 24 bits, are their means for one window; they
/// fit in 32 bits.
constexpr int reciprocal_bits = 24;

uint8_t mean(uint32_t sum, uint32_t reciprocal) {
  return static_cast<uint8_t>((sum * reciprocal + (uint32_t{1} << (reciprocal_bits - 1))) >>
                              reciprocal_bits);
}

uint32_t reciprocal_of(int window) {
  return ((uint32_t{1} << reciprocal_bits) + static_cast<uint32_t>(window) / 2) /
         static_cast<uint32_t>(window);
}

void blur_row(const uint8_t* in, uint8_t* out, int width, int step, int radius) {
  const uint32_t reciprocal = reciprocal_of(2 * radius + 1);
  const auto clamped = [&](int x) { return in[std::clamp(x, 0, width - 1) * step]; };
  uint32_t sum = 0;
  for (int x = -radius; x <= radius; ++x) sum += clamped(x);
  const auto blur = [&](int begin, int end, const auto& value) {
    for (int x = begin; x < end; ++x) {
      out[x * step] = mean(sum, reciprocal);
      sum += value(x + radius + 1);
      sum -= value(x - radius);
    }
  };
  const int first = std::min(radius, width);
  const int last = std::max(first, width - radius - 1);
  blur(0, first, clamped);
  blur(first, last, [&](int x) { return in[x * step]; });
  blur(last, width, clamped);
}

Image8 blur_rows(const Image8& image, int radius) {
  Image8 result(image.width, image.height, image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int c = 0; c < image.channels; ++c)
      blur_row(&image.at(0, y, c), &result.at(0, y, c), image.width, image.channels, radius);
  return result;
}

Image8 blur_columns(const Image8& image, int radius) {
  const uint32_t reciprocal = reciprocal_of(2 * radius + 1);
  const size_t n = static_cast<size_t>(image.width) * image.channels;
  const auto row = [&](int y) { return &image.at(0, std::clamp(y, 0, image.height - 1)); };
  Image8 result(image.width, image.height, image.channels);
  std::vector<uint32_t> sums(n, 0);
  for (int y = -radius; y <= radius; ++y)
    for (size_t i = 0; i < n; ++i) sums[i] += row(y)[i];
  for (int y = 0; y < image.height; ++y) {
    uint8_t* out = &result.at(0, y);
    const uint8_t* enters = row(y + radius + 1);
    const uint8_t* leaves = row(y - radius);
    for (size_t i = 0; i < n; ++i) {
      out[i] = mean(sums[i], reciprocal);
      sums[i] += enters[i];
      sums[i] -= leaves[i];
    }
  }
  return result;
}

/// Mean of one channel over a block that the image may cut off.
uint8_t block_mean(const Image8& image, int x, int y, int side, int channel) {
  const int width = std::min(side, image.width - x);
  const int height = std::min(side, image.height - y);
  uint64_t sum = 0;
  for (int v = y; v < y + height; ++v) {
    const uint8_t* in = &image.at(x, v, channel);
    uint32_t row = 0;
    for (int u = 0; u < width; ++u) row += in[static_cast<ptrdiff_t>(u) * image.channels];
    sum += row;
  }
  const uint64_t count = static_cast<uint64_t>(width) * height;
  return static_cast<uint8_t>((sum + count / 2) / count);
}

}  // namespace

Image8 box_blur(const Image8& image, int radius) {
  assert(radius >= 0 && radius <= 2000);
  if (radius == 0 || image.empty()) return image;
  return blur_columns(blur_rows(image, radius), radius);
}

Image8 shrink(const Image8& image, int factor) {
  assert(factor >= 1);
  if (factor == 1 || image.empty()) return image;
  const int w = (image.width + factor - 1) / factor;
  const int h = (image.height + factor - 1) / factor;
  Image8 result(w, h, image.channels);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      for (int c = 0; c < image.channels; ++c)
        result.at(x, y, c) = block_mean(image, x * factor, y * factor, factor, c);
  return result;
}

}  // namespace relievo

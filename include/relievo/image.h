#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relievo {

/// A pixel grid, row-major, top row first, channels interleaved.
template <class T>
struct Image {
  int width = 0;
  int height = 0;
  int channels = 1;
  std::vector<T> pixels;  ///< width * height * channels

  Image() = default;
  Image(int w, int h, int c, T fill = T())
      : width(w), height(h), channels(c), pixels(static_cast<size_t>(w) * h * c, fill) {}

  bool empty() const { return pixels.empty(); }
  T& at(int x, int y, int c = 0) { return pixels[index(x, y, c)]; }
  const T& at(int x, int y, int c = 0) const { return pixels[index(x, y, c)]; }

 private:
  size_t index(int x, int y, int c) const {
    return (static_cast<size_t>(y) * width + x) * channels + c;
  }
};

using Image8 = Image<uint8_t>;
using Image16 = Image<uint16_t>;
using ImageF = Image<float>;

/// The artist's drawing as pixels: 8-bit sRGB with straight alpha, 4 channels. It covers the whole
/// canvas of the scene; its resolution may differ from the canvas size. Empty if there is none.
struct Drawing {
  Image8 rgba;
  int pixel_art = 0;  ///< side of the squares that are pixel art's own pixels, px; else 0. Pixel
                      ///< art is shown without smoothing
};

}  // namespace relievo

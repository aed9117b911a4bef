#pragma once

#include <random>

#include "relievo/image.h"

namespace relievo {

/// Bytes that are 0 except for a share of about `density`, which are 1 ... 255.
inline Image8 random_image(int width, int height, double density, uint32_t seed, int channels = 1) {
  std::mt19937 random(seed);
  Image8 image(width, height, channels);
  for (uint8_t& value : image.pixels)
    if (static_cast<double>(random() % 1000) < density * 1000)
      value = static_cast<uint8_t>(1 + random() % 255);
  return image;
}

/// The image turned a quarter clockwise.
template <class T>
Image<T> turned(const Image<T>& image) {
  Image<T> result(image.height, image.width, image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < image.channels; ++c)
        result.at(image.height - 1 - y, x, c) = image.at(x, y, c);
  return result;
}

/// The image mirrored left to right.
template <class T>
Image<T> mirrored(const Image<T>& image) {
  Image<T> result(image.width, image.height, image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < image.channels; ++c)
        result.at(image.width - 1 - x, y, c) = image.at(x, y, c);
  return result;
}

}  // namespace relievo

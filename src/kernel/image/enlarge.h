#pragma once

#include <algorithm>

#include "relievo/image.h"

namespace relievo {

/// Longer side below which a picture is small, px: rules with a length in pixels need that many.
constexpr int small_side = 300;

/// Returns the least whole number that makes a side of small_side px of a picture's longer one.
inline int enlargement(int width, int height) {
  const int longest = std::max({width, height, 1});
  return (small_side + longest - 1) / longest;
}

/// Returns whether two pixels (RGBA) have one colour. Transparent ones do.
bool is_same_colour(const uint8_t* a, const uint8_t* b);

/// Returns the largest side of squares of one colour that make a picture (RGBA). O(pixels).
int square_side(const Image8& rgba);

/// Enlarges an image by whole pixels: each becomes a square of times x times equal ones.
template <class T>
Image<T> enlarged(Image<T> image, int times) {
  if (times == 1) return image;
  Image<T> large(times * image.width, times * image.height, image.channels);
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x)
      std::copy_n(&image.at(x / times, y / times), image.channels, &large.at(x, y));
  return large;
}

}  // namespace relievo

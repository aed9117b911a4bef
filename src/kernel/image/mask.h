#pragma once

#include <cstdint>

#include "relievo/image.h"

namespace relievo {

/// A set of pixels of a canvas, stored inside a box. Pixels outside the box are not in it.
struct Mask {
  int left = 0;   ///< column of the box's first pixel on the canvas; may be negative
  int top = 0;    ///< row of that pixel; may be negative
  Image8 inside;  ///< 1 where a pixel of the box belongs to the set, else 0; 1 channel

  int right() const { return left + inside.width; }   ///< one past the last column
  int bottom() const { return top + inside.height; }  ///< one past the last row
  /// Returns whether the canvas pixel (x, y) is in the box.
  bool covers(int x, int y) const { return x >= left && y >= top && x < right() && y < bottom(); }
  /// Returns whether the canvas pixel (x, y) is in the set.
  bool has(int x, int y) const { return covers(x, y) && inside.at(x - left, y - top) != 0; }
  /// Adds a pixel of the box.
  void add(int x, int y) { inside.at(x - left, y - top) = 1; }
  /// Removes a pixel of the box.
  void remove(int x, int y) { inside.at(x - left, y - top) = 0; }
};

/// Returns an empty set in the box [left, right) x [top, bottom).
inline Mask empty_mask(int left, int top, int right, int bottom) {
  return {left, top, Image8(right - left, bottom - top, 1)};
}

/// Calls visit(x, y) for each pixel of the set, row by row. O(box).
template <class Visit>
void for_each_pixel(const Mask& mask, Visit visit) {
  for (int y = 0; y < mask.inside.height; ++y)
    for (int x = 0; x < mask.inside.width; ++x)
      if (mask.inside.at(x, y) != 0) visit(mask.left + x, mask.top + y);
}

/// Returns the image that is 1 at the pixels, by index, of which is(i) is true. O(pixels).
template <class Is>
Image8 mask_where(int width, int height, const Is& is) {
  Image8 mask(width, height, 1);
  for (size_t i = 0; i < mask.pixels.size(); ++i) mask.pixels[i] = is(i) ? 1 : 0;
  return mask;
}

/// Counts the ones of an image of zeros and ones. O(pixels).
inline int64_t pixel_count(const Image8& mask) {
  int64_t count = 0;
  for (const uint8_t value : mask.pixels) count += value;
  return count;
}

/// Counts the pixels of the set. O(box).
inline int64_t pixel_count(const Mask& mask) { return pixel_count(mask.inside); }

}  // namespace relievo

#pragma once

#include "relievo/image.h"

namespace relievo {

/// Returns the mask that is 1 at the pixels, by index, of which is(i) is true. O(pixels).
template <class Is>
Image8 mask_where(int width, int height, const Is& is) {
  Image8 mask(width, height, 1);
  for (size_t i = 0; i < mask.pixels.size(); ++i) mask.pixels[i] = is(i) ? 1 : 0;
  return mask;
}

/// Computes the share of their bounding box that the ones of a mask fill; 0 for an empty mask.
/// O(pixels).
double share_of_box(const Image8& mask);

/// Removes the pieces of a mask that have less than 3 % of the largest piece's area. O(pixels).
Image8 without_small_pieces(const Image8& mask);

/// Fills the holes of a mask: all pixels that it surrounds become 1. O(pixels).
Image8 without_holes(const Image8& mask);

}  // namespace relievo

#pragma once

#include "relievo/image.h"

namespace relievo {

/// Computes the share of their bounding box that the ones of a mask fill; 0 for an empty mask.
/// O(pixels).
double share_of_box(const Image8& mask);

/// Removes the pieces of a mask that have less than 3 % of the largest piece's area. O(pixels).
Image8 without_small_pieces(const Image8& mask);

/// Fills the holes of a mask: all pixels that it surrounds become 1. O(pixels).
Image8 without_holes(const Image8& mask);

}  // namespace relievo

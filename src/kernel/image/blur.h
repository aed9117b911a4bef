#pragma once

#include "relievo/image.h"

namespace relievo {

/// Computes the rounded mean over the square of side 2 radius + 1 around each pixel, for each
/// channel separately. Pixels of the border repeat outwards. Precondition: 0 <= radius <= 2000.
/// O(values).
Image8 box_blur(const Image8& image, int radius);

/// Computes the rounded means over blocks of `factor` x `factor` pixels; blocks at the right and
/// the bottom border may be smaller. Precondition: factor >= 1. O(values).
Image8 shrink(const Image8& image, int factor);

}  // namespace relievo

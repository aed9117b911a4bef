#pragma once

#include "relievo/image.h"

namespace relievo {

/// Mean over the square of side 2 radius + 1 around each pixel, rounded; the border pixels repeat
/// outwards. Each channel by itself. Precondition: 0 <= radius <= 2000. O(values).
Image8 box_blur(const Image8& image, int radius);

/// Means over blocks of `factor` x `factor` pixels; the blocks at the right and bottom border may
/// be smaller. Precondition: factor >= 1. O(values).
Image8 shrink(const Image8& image, int factor);

}  // namespace relievo

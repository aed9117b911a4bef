#pragma once

#include <cstdint>
#include <limits>

#include "relievo/image.h"

namespace relievo {

/// Mean over the square of side 2 radius + 1 around each pixel, rounded; the border pixels repeat
/// outwards. Each channel by itself. Precondition: 0 <= radius <= 2000. O(values).
Image8 box_blur(const Image8& image, int radius);

/// Means over blocks of `factor` x `factor` pixels; the blocks at the right and bottom border may
/// be smaller. Precondition: factor >= 1. O(values).
Image8 shrink(const Image8& image, int factor);

/// Fills what is unknown smoothly from what is known: each pixel takes the colour of the finest
/// mean around it that knows one (pull-push; Gortler et al., The Lumigraph, 1996, section 3.4).
/// `colours` has any channels, the last one the weight in [0, 1]: 0 unknown, 1 known. Returns the
/// others; 0 everywhere where nothing is known. O(values).
ImageF pull_push(const ImageF& colours);

/// What squared_distance_to says everywhere where the mask is empty.
constexpr int32_t no_distance = std::numeric_limits<int32_t>::max();

/// Exact squared Euclidean distance, px^2, from every pixel centre to the nearest pixel of `mask`
/// that is not 0; 0 on the mask itself. Precondition: one channel, sides up to 32767. O(pixels).
/// Meijster, Roerdink, Hesselink: A general algorithm for computing distance transforms in linear
/// time (2000).
Image<int32_t> squared_distance_to(const Image8& mask);

}  // namespace relievo

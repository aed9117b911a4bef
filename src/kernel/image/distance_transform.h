#pragma once

#include <cstdint>
#include <limits>

#include "relievo/image.h"

namespace relievo {

/// The value of squared_distance_to everywhere for an empty mask.
constexpr int32_t no_distance = std::numeric_limits<int32_t>::max();

/// Computes the exact squared Euclidean distance, px^2, from each pixel centre to the nearest pixel
/// of `mask` that is not 0; 0 on the mask itself. Precondition: one channel, sides up to 32767.
/// O(pixels). Meijster, Roerdink, Hesselink: A general algorithm for computing distance transforms
/// in linear time (2000).
Image<int32_t> squared_distance_to(const Image8& mask);

/// Returns an image that is 1 on the pixels within `distance` px of those of a mask, else 0.
Image8 pixels_within(const Image8& mask, int distance);

}  // namespace relievo

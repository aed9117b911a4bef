#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// Returns whether a drawing (4 channels) lies on transparency or on pure white, which no scanner
/// and no camera gives: then every other colour is paint. False where the paint fills its box, as a
/// photograph in a white frame does. O(pixels).
bool is_on_pure_white(const Image8& rgba);

/// Returns 1 where a picture on pure white or transparency (3 or 4 channels) is not white.
/// O(pixels).
Image8 tinted_pixels(const Image8& image);

}  // namespace relievo::understanding

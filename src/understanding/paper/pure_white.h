#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// Minimum share of the picture's border that is pure white, for a figure such as a bust that the
/// border cuts off.
constexpr double bust_share = 0.6;

/// What fills so much of its box is a picture in a frame.
constexpr double framed_share = 0.9;

/// Whether a drawing (4 channels) lies on nothing or on white as no scanner and no camera gives it:
/// then whatever is not white is paint, unless it fills a box, as a photograph in a white frame
/// does. O(pixels).
bool is_on_pure_white(const Image8& rgba);

/// 1 where a picture on pure white, or on nothing, is not white. O(pixels).
Image8 tinted_pixels(const Image8& image);

}  // namespace relievo::understanding

#pragma once

#include <optional>

#include "relievo/image.h"

namespace relievo {

/// Returns the side of the squares that are the own pixels of pixel art, px: 1 for pixel art at its
/// own size, more where it was enlarged by whole pixels, 0 for other pictures. Pixel art has less
/// than small_side of its own pixels a side, few colours, and steps between them: where one colour
/// meets another, few pixels blend both, as they do in smoothed drawings. `is_pixel_art`, if known,
/// replaces these criteria. O(pixels); ends early on most pictures that are not small.
int own_pixels(const Image8& rgba, std::optional<bool> is_pixel_art = {});

/// Returns the longest side of the maps of a drawing, px: `usual`, or for pixel art the largest
/// multiple of its own size up to that; at least its own size.
int map_side(const Drawing& drawing, int usual);

}  // namespace relievo

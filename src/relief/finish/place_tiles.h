#pragma once

#include <array>
#include <vector>

#include "kernel/image/image_size.h"

namespace relievo::relief {

/// Places tiles on shelves below a picture, the high ones first, with gaps between them so that
/// filtering does not mix their colours. `height` grows from that of the picture to that of all.
/// Returns the x and y of each tile's top left pixel. Precondition: no tile is wider than the
/// picture. O(n log n).
std::vector<std::array<int, 2>> place_tiles(const std::vector<ImageSize>& tiles, int width,
                                            int& height);

}  // namespace relievo::relief

#pragma once

#include <cstdint>

#include "relievo/image.h"

namespace relievo::understanding {

/// Gives each pixel on an edge between colours, and up to 2 px beside it, to the basin whose colour
/// on either side of the edge is closer to its own. Edges are found to about 2 px, and a flood
/// leaves their pixels to the basin that is above or to the left. `rgb` is the drawing on white,
/// `barrier` that of LineMap before contours are added, `index` the basin of every pixel.
/// O(pixels).
void settle_edges(const Image8& rgb, const Image8& barrier, Image<int32_t>& index);

}  // namespace relievo::understanding

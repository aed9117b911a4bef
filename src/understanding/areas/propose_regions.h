#pragma once

#include "relievo/image.h"
#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Fills region, region_count and unbounded_ink: unites basins that are open to each other, finds
/// the background at the edges of the image, and gives slivers and small enclosed details to what
/// lies around them. `rgb` is the drawing on white. O(pixels + borders log borders).
void propose_regions(const Image8& rgb, Basins& basins);

}  // namespace relievo::understanding

#pragma once

#include "relief/drawing/basins.h"

namespace relievo {

/// Fills region, region_count and unbounded_ink: unites basins that are open to each other, finds
/// the background at the edges of the image, and gives slivers and small enclosed details to what
/// lies around them. O(borders log borders).
void propose_regions(Basins& basins);

}  // namespace relievo

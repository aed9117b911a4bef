#pragma once

#include "relievo/image.h"
#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Computes `basins.region`, `region_count` and `unbounded_ink`. Unites basins that are open to
/// each other, finds the background, gives slivers and small details to the regions around them,
/// and unites neighbours and pieces that are likely one part. Settles the gaps of `basins.barrier`.
/// `rgb` is the drawing on white. O(pixels + borders log borders).
void propose_regions(const Image8& rgb, Basins& basins);

}  // namespace relievo::understanding

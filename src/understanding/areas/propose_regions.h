#pragma once

#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Computes `basins.region`, `region_count` and `unbounded_ink`. Basins outside the figure become
/// background. Of the others, neighbours are united that are likelier one part than two, and
/// slivers with their likeliest neighbours. O(pixels + borders log borders).
void propose_regions(Basins& basins);

}  // namespace relievo::understanding

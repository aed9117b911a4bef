#pragma once

#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Changes the proposed regions until there are `count`, or as near to it as can be: those that are
/// likeliest one are united, or the least likely unions of basins undone. What was proposed as
/// background stays. Precondition: count > 0. O(borders log borders), and O(basins) for each
/// region that is divided.
void count_regions(int count, Basins& basins);

}  // namespace relievo::understanding

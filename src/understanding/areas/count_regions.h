#pragma once

#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Changes the number of proposed regions to `count`, or as near to it as possible: unites those
/// that are likeliest one part, or undoes the least likely unions of basins. The background stays
/// as proposed. Precondition: count > 0. O(borders log borders), and O(basins) for each region that
/// is divided.
void count_regions(int count, Basins& basins);

}  // namespace relievo::understanding

#pragma once

#include <vector>

#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Joins proposed regions to the scribbled parts that they touch, the surest first: where the
/// common border is long and open, and the colours are alike. `labels`: [#B] 1 ... `part_count` are
/// scribbled parts, larger ones proposed regions. Regions without any connection to a scribbled
/// part stay. O(regions * borders between regions).
void join_regions(const Basins& basins, int part_count, std::vector<int>& labels);

}  // namespace relievo::understanding

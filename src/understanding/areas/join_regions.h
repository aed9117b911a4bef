#pragma once

#include <vector>

#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Gives proposed regions to the scribbled parts that they touch, the surest first: where the
/// border is long and open, and the colour alike. `labels` has those of basins: 1 ... `part_count`
/// are scribbled parts, more are proposed regions; what touches neither a scribbled part nor what
/// joined one stays. O(regions * borders between regions).
void join_regions(const Basins& basins, int part_count, std::vector<int>& labels);

}  // namespace relievo::understanding

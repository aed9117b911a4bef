#pragma once

#include <cstdint>
#include <vector>

#include "understanding/joins/join_proposals.h"
#include "understanding/joins/layer_grid.h"

namespace relievo::understanding {

/// Finds the parts that look hollow by their colours: open mouths, which lie inside a larger part,
/// are wide, red and much darker than it; and the cups of ears, which are pink, not dark, and fill
/// a good share of a limb. `limb` is 1 for each part that is a limb. The result is in ascending
/// order, and empty where no colours are known.
std::vector<int> hollow_parts(const LayerGrid& grid, const PartColors& colors,
                              const std::vector<uint8_t>& limb);

}  // namespace relievo::understanding

#pragma once

#include <cstdint>
#include <vector>

#include "relief/join_proposals/join_proposals.h"
#include "relief/join_proposals/layer_grid.h"

namespace relievo {

/// The parts that look hollow by their colours: open mouths, wholly inside a larger part, wide, red
/// and much darker than that; and the cups of ears, pink and not dark, which fill a good share of a
/// limb. `limb` tells of each part whether it is one. Ascending; none where no colours are known.
std::vector<int> hollow_parts(const LayerGrid& grid, const PartColors& colors,
                              const std::vector<uint8_t>& limb);

}  // namespace relievo

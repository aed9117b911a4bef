#pragma once

#include <cstdint>
#include <vector>

#include "understanding/joins/join_proposals.h"
#include "understanding/joins/roots.h"

namespace relievo::understanding {

/// The parts that look hollow by their colours: open mouths, wholly inside a larger part, wide, red
/// and much darker than that; and the cups of ears, pink and not dark, which fill a good share of a
/// limb. `limb` tells of each part whether it is one. Ascending; none where no colours are known.
std::vector<int> hollow_parts(const LayerGrid& grid, const PartColors& colors,
                              const std::vector<uint8_t>& limb);

}  // namespace relievo::understanding

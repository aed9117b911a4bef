#pragma once

#include "understanding/areas/basins.h"
#include "understanding/labels/basin_votes.h"

namespace relievo::understanding {

/// Returns whether hard strokes of different labels lie in one basin.
bool needs_split(const BasinVotes& votes);

/// Divides every basin that contains hard strokes of several labels into one for each, by a
/// watershed from the strokes that meets at the narrowest place between them. Moves the hard pixels
/// of `votes` to the new basins. O(pixels in the boxes of these basins).
Basins split_basins(Basins basins, BasinVotes& votes);

}  // namespace relievo::understanding

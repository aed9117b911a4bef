#pragma once

#include <vector>

#include "understanding/areas/basins.h"
#include "understanding/labels/basin_votes.h"
#include "understanding/labels/scribbles.h"

namespace relievo::understanding {

/// Chooses the label of every basin: 0 background, k + 1 Scribbles::parts[k] (#P of them), #P + r
/// the proposed region r. Minimises LazyBrush's energy over the basins that strokes leave free.
std::vector<int> choose_labels(const Basins& basins, const BasinVotes& votes,
                               const Scribbles& scribbles);

}  // namespace relievo::understanding

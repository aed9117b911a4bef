#pragma once

#include <vector>

#include "relief/drawing/basin_votes.h"
#include "relief/drawing/scribbles.h"

namespace relievo {

/// The label of every basin: 0 background, k + 1 Scribbles::parts[k] (#P of them), #P + r the
/// proposed region r. Minimises LazyBrush's energy over the basins that strokes leave free.
std::vector<int> choose_labels(const Basins& basins, const BasinVotes& votes,
                               const Scribbles& scribbles);

}  // namespace relievo

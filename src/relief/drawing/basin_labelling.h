#pragma once

#include <vector>

#include "relief/drawing/basin_votes.h"
#include "relief/drawing/label_basins.h"

namespace relievo {

/// The label of every basin: 0 background, k + 1 Scribbles::parts[k] (`part_count` of them),
/// part_count + r the proposed region r. Minimises LazyBrush's energy over the basins that strokes
/// leave free.
std::vector<int> choose_labels(const Basins& basins, const BasinVotes& votes, int part_count,
                               const LabelOptions& options);

}  // namespace relievo

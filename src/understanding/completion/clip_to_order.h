#pragma once

#include <vector>

#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

/// The completed parts without what would be seen: each shape keeps its visible part and what
/// lies below parts in front of it (larger `rank`), in one piece with the visible part. Where
/// parts behind it end its visible part, that boundary goes on below those in front: `below_front`
/// is the completion whose occluders are those in front only, and both must agree, unless that is a
/// membrane, which fits anything, and this is not. Every
/// part reaches at least `overlap` px below the neighbours in front of it, so that no crack
/// remains between them; what is hidden keeps 2 px away from where its occluders end, so that no
/// two outlines run along each other. Shapes that the user gave are kept. O(boxes of the parts).
Completion clip_to_order(const PartRegions& regions, const Completion& completion,
                         const Completion& below_front, const std::vector<int>& rank, int overlap);

}  // namespace relievo::understanding

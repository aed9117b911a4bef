#pragma once

#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

/// Cuts off what would be seen of completed parts that are sorted back to front. Each shape keeps
/// its visible part and the region below parts in front of it, in one piece with the visible part.
/// Where parts behind it end its visible part, that boundary continues below the parts in front:
/// `below_front` has the completions whose occluders are the parts in front only, and a pixel must
/// lie in both shapes, unless that of `below_front` is a membrane, which fits anything, and the
/// other is not. Every part reaches at least `overlap` px below the neighbours in front of it, so
/// that no crack remains between them; a hidden region keeps 2 px away from where its occluders
/// end, so that no two outlines coincide. Shapes that the user gave are kept. O(boxes of the
/// parts).
Completion clip_to_order(const PartRegions& regions, const Completion& completion,
                         const Completion& below_front, int overlap);

}  // namespace relievo::understanding

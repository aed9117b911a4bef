#pragma once

#include "io/project/project.h"
#include "relief/completion/part_regions.h"
#include "relief/joining/joining.h"

namespace relievo {

/// What a proposal says of a segmented drawing, with labels for its part indices: parts, order and
/// joins of the record. `scene` is the one that the proposal makes.
SegmentationRecord record_proposal(const PartRegions& regions, const Completion& completion,
                                   const Stacking& stacking, const Joining& joining,
                                   const Scene& scene);

}  // namespace relievo

#pragma once

#include <vector>

#include "understanding/completion/part_regions.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/labels/corrections.h"
#include "understanding/labels/drawing_evidence.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// Proposes how every part connects with those behind it. A part whose completed outline shows that
/// it is a limb of another is joined to that at the cap of its root (see propose_layer_joins). Of
/// the others that touch:
///  - join: the outline of the part has exactly one run, its root, that borders on the part behind;
///    the root is at least 10 % of the outline, the rest of which goes elsewhere; and what is seen
///    of the part is at most 10 times as large as what is seen of the lower one, unlike a body over
///    a far arm. The join is the middle of the root; the ramps beside it are as long as the root
///    exceeds its chord, so that they end where a limb leaves the lower part, and become Robin
///    ranges. A clear change of colour halves the confidence, since hats are not grown on, but
///    sleeves are. Where the two have grown together, neither the root's share nor the size
///    matters. A part that grows out from behind another with more confidence has no such join:
///    legs behind a skirt do not grow out of the cape behind them;
///  - equal: the outline does not touch the background, as that of an eye or a button; or the
///    completed outlines tie the two, as a limb that comes out from behind a larger part; or
///    neither is in front of the other with a probability of at least 0.6;
///  - above: all others.
/// `regions` are sorted back to front, `outlines` are those of the parts in the scene. `order` has
/// the arrows of stack_parts. The user's corrections are never overruled. O(sides).
JoinProposals propose_joins(const PartRegions& regions, const std::vector<Outline>& outlines,
                            const std::vector<OrderArrow>& order,
                            const Corrections& corrections = {},
                            const DrawingEvidence& evidence = {});

}  // namespace relievo::understanding

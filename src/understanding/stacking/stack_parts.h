#pragma once

#include <utility>
#include <vector>

#include "relievo/result.h"
#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// Orders parts, which are in the order of their labels, in depth. Five cues, each in [-1, 1], tell
/// which of two neighbours is in front:
///  - shape: the other extends further below it, (gain_other - gain_own) / (sum + 1.5 px * length);
///  - contour: the common boundary fits the rest of its contour and not that of the other;
///  - junctions: its contour runs straight through points where three regions meet more often than
///    the other's;
///  - bulge: it bulges into the other;
///  - floor: the other reaches down to where the figure ends, and it does not.
/// A logistic model of the cues gives the probability p; the likelier direction becomes an arrow
/// with the confidence 2 p - 1. Cycles are broken at the least confident guess. `user_arrows` (in
/// front, behind) replace guesses between their parts and are always kept. Errors: `contradiction`
/// where user arrows form a circle.
Result<Stacking> stack_parts(const PartRegions& regions,
                             const std::vector<NeighbourEvidence>& evidence,
                             const std::vector<std::pair<PartLabel, PartLabel>>& user_arrows = {});

}  // namespace relievo::understanding

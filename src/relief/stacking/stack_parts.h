#pragma once

#include <utility>
#include <vector>

#include "relief/completion/completion.h"
#include "relief/completion/part_regions.h"
#include "relief/stacking/stacking.h"
#include "relievo/result.h"

namespace relievo {

/// An arrow of the user: the first part is in front of the second.
using UserArrow = std::pair<int, int>;

/// Orders the parts in depth. Four cues tell which of two neighbours is in front, each with a
/// probability:
///  - shape: the other goes on further below it, (gain_other - gain_own) / (sum + 1.5 px * length);
///  - contour: the common boundary fits the rest of its contour and not that of the other;
///  - junction: its contour runs straight through where three regions meet;
///  - bulge: it bulges into the other.
/// Per direction they are united as independent ones, 1 - (1 - p)(1 - q)..., and the likelier
/// direction becomes an arrow whose confidence is the difference. Cycles are cut at the least
/// confident guess; user arrows replace guesses between their parts and are kept. Errors:
/// `contradiction` where user arrows form a circle.
Result<Stacking> stack_parts(const PartRegions& regions,
                             const std::vector<NeighbourEvidence>& evidence,
                             const std::vector<UserArrow>& user_arrows = {});

}  // namespace relievo

#pragma once

#include <utility>
#include <vector>

#include "relievo/result.h"
#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// An arrow of the user: the first part is in front of the second.
using UserArrow = std::pair<int, int>;

/// Orders the parts in depth. Five cues tell which of two neighbours is in front, each in [-1, 1]:
///  - shape: the other goes on further below it, (gain_other - gain_own) / (sum + 1.5 px * length);
///  - contour: the common boundary fits the rest of its contour and not that of the other;
///  - junctions: its contour runs straight through where three regions meet, more often than the
///    other's;
///  - bulge: it bulges into the other;
///  - ground: the other reaches down to where the figure ends, and it does not.
/// A logistic model of them gives the probability p; the likelier direction becomes an arrow whose
/// confidence is 2 p - 1. Cycles are cut at the least confident guess; user arrows replace guesses
/// between their parts and are kept. Errors: `contradiction` where user arrows form a circle.
Result<Stacking> stack_parts(const PartRegions& regions,
                             const std::vector<NeighbourEvidence>& evidence,
                             const std::vector<UserArrow>& user_arrows = {});

}  // namespace relievo::understanding

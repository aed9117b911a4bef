#pragma once

#include <utility>
#include <vector>

#include "kernel/base/result.h"
#include "relief/completion/completion.h"
#include "relief/completion/part_regions.h"
#include "relief/stacking/stacking.h"

namespace relievo {

/// An arrow of the user: the first part is in front of the second.
using UserArrow = std::pair<int, int>;

/// Orders the parts in depth. Two neighbours are compared by how far each goes on below the
/// other (score (gain_a - gain_b) / (gain_a + gain_b)) and by the junctions of their contours;
/// per direction, the probabilities of both cues are united as independent ones,
/// 1 - (1 - p)(1 - q), and the likelier direction becomes an arrow whose confidence is the
/// difference. Cycles are cut at the least confident guess; user arrows replace guesses between
/// their parts and are kept. Errors: `contradiction` where user arrows form a circle.
Result<Stacking> stack_parts(const PartRegions& regions, const std::vector<MutualGain>& gains,
                             const std::vector<UserArrow>& user_arrows = {});

}  // namespace relievo

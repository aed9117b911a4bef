#pragma once

#include <utility>
#include <vector>

#include "relievo/result.h"
#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// Finds parts whose contours bulge into a neighbour: they are in front of it, since figures are
/// convex. There is one guess for every two neighbours whose common boundary is curved: with A the
/// area between the boundary and its chords, signed and summed over its runs, and C the sum of the
/// squared chords,
///   confidence = 1 - exp(-|A| / (0.06 C)),
/// which is 1 where one part is a hole of the other. A semicircle has A / C = 0.39 (after Palou and
/// Salembier 2013). O(sides).
std::vector<OrderArrow> find_bulges(const PartRegions& regions);

/// Finds the parts that hide others at T-junctions: their contours run nearly straight through a
/// point where three parts meet. There is a guess for each junction and hidden part, with a
/// confidence (see t_junction_confidence) of at least 0.01. O(sides).
std::vector<OrderArrow> find_junction_cues(const PartRegions& regions);

/// Orders parts, which are in the order of their labels, in depth. Six cues, each in [-1, 1], tell
/// which of two neighbours is in front:
///  - shape: the other extends further below it, (gain_other - gain_own) / (sum + 1.5 px * length);
///  - contour: the common boundary fits the rest of its contour and not that of the other;
///  - junctions: its contour runs straight through points where three regions meet more often than
///    the other's;
///  - bulge: it bulges into the other;
///  - floor: the other reaches down to where the figure ends, and it does not;
///  - front: the network sees it in front (see NeighbourEvidence::front).
/// A logistic model of the cues gives the probability p; the likelier direction becomes an arrow
/// with the confidence 2 p - 1. Cycles are broken at the least confident guess. `user_arrows` (in
/// front, behind) replace guesses between their parts and are always kept. Errors: `contradiction`
/// where user arrows form a circle.
Result<Stacking> stack_parts(const PartRegions& regions,
                             const std::vector<NeighbourEvidence>& evidence,
                             const std::vector<std::pair<PartLabel, PartLabel>>& user_arrows = {});

}  // namespace relievo::understanding

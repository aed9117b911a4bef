#pragma once

#include <vector>

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

}  // namespace relievo::understanding

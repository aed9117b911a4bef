#pragma once

#include <vector>

#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

/// A part whose contour bulges into a neighbour is in front of it: figures are convex.
struct BulgeCue {
  int upper = -1;
  int lower = -1;
  double confidence = 0;  ///< in [0, 1]
};

/// One cue for every two neighbours whose common boundary is curved: with A the area between the
/// boundary and its chords, signed and summed over its runs, and C the sum of the squared chords,
/// the confidence is 1 - exp(-|A| / (0.06 C)), and 1 where one part is a hole of the other. A
/// semicircle has A / C = 0.39 (after Palou and Salembier 2013). O(sides).
std::vector<BulgeCue> find_bulge_cues(const PartRegions& regions);

}  // namespace relievo::understanding

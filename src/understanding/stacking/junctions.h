#pragma once

#include <vector>

#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

/// A T-junction: `upper`, whose contour runs nearly straight through a point where three parts
/// meet, hides `lower` there.
struct JunctionCue {
  int upper = -1;  ///< index of a part
  int lower = -1;
  double confidence = 0;  ///< in [0.01, 1], see t_junction_confidence
};

/// Finds the cues of all T-junctions. O(sides).
std::vector<JunctionCue> find_junction_cues(const PartRegions& regions);

}  // namespace relievo::understanding

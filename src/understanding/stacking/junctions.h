#pragma once

#include <vector>

#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

/// A region whose contour runs nearly straight through a point where three regions meet is in
/// front of the two others there.
struct JunctionCue {
  int upper = -1;
  int lower = -1;
  double confidence = 0;  ///< in [0, 1]
};

/// The cues of all junctions: exp(-|angle - pi| / s^2) with s = pi / 6, from the directions of a
/// part's contour on both sides of the junction (after G. Palou and P. Salembier, Monocular depth
/// ordering using T-junctions and convexity occlusion cues, 2013). Cues below 0.01 are left out.
/// O(sides).
std::vector<JunctionCue> find_junction_cues(const PartRegions& regions);

}  // namespace relievo::understanding

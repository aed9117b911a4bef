#pragma once

#include <vector>

#include "relief/completion/part_regions.h"
#include "relief/stacking/stacking.h"
#include "relievo/result.h"

namespace relievo {

/// Gives up guessed arrows until no cycle is left: while there is one, the least confident guess
/// that lies on a cycle (of equals, the one with the smallest `weight`, then the first). Arrows of
/// the user are never given up; a cycle of those alone is an error (`contradiction`) that names
/// its parts by `name`. O(arrows * (parts + arrows)).
Status break_cycles(int parts, std::vector<OrderArrow>& arrows);

/// Parts back to front along the kept arrows; among parts that may come next, the one with the
/// largest `area` first. Precondition: no cycles. O(parts^2 + arrows).
std::vector<int> sort_back_to_front(const std::vector<double>& area,
                                    const std::vector<OrderArrow>& arrows);

/// Moves parts, one at a time, as long as that makes the order likelier. `log_odds[p][q]` are those
/// of p being in front of q, and -log_odds[q][p]. O(parts^2) a round of moves, of which few are
/// needed.
std::vector<int> likelier_order(std::vector<int> back_to_front,
                                const std::vector<std::vector<double>>& log_odds);

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

}  // namespace relievo

#pragma once

#include <vector>

#include "relievo/run_context.h"
#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

struct CompletionOptions {
  int min_shared_sides = 4;  ///< neighbours with a shorter common boundary do not count
};

/// Per part, the sorted parts that may hide some of it.
using Occluders = std::vector<std::vector<int>>;

/// Completes every part below its occluders. Three ways are tried, and the first that explains
/// what is seen is taken; the membrane always is possible:
///  - ellipse: the known contour lies on one within its noise, and of the ellipse and of the
///    visible part at most 4 % disagree;
///  - continuation: the part is in one piece, and every gap of its contour is bridged by an arc
///    that turns by less than one and a half right angles and stays in place;
///  - membrane: the illusory surface.
/// The shape contains the visible part, stays within it and its occluders, and all of it is
/// connected to the visible part. O(pixels of the boxes around the parts).
Result<Completion> complete_parts(const PartRegions& regions, const Occluders& occluders,
                                  const RunContext& context = {});

/// Compares every two neighbours: each part is completed as if all others could hide it, and an
/// ellipse is fitted to its contour with and without the common boundary. O(pixels of the boxes
/// around the parts + pairs).
Result<std::vector<NeighbourEvidence>> compare_neighbours(const PartRegions& regions,
                                                          const CompletionOptions& options = {},
                                                          const RunContext& context = {});

}  // namespace relievo::understanding

#pragma once

#include <initializer_list>
#include <vector>

#include "relievo/run_context.h"
#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

/// Per part, the sorted parts that may hide some of it.
using Occluders = std::vector<std::vector<int>>;

/// Completes every part below its occluders. Three ways are tried in this order, and the first that
/// explains the visible pixels is taken; the membrane always does:
///  - ellipse: the known contour lies on an ellipse within its noise, and at most 4 % of the
///    ellipse and of the visible part disagree;
///  - continuation: smooth arcs bridge the gaps of the contour (see bridge_gaps), and the shape
///    agrees with the visible part as above;
///  - membrane: the illusory surface.
/// The shape contains the visible part, stays within it and its occluders, and is connected. A part
/// that one of `known` completes below the same occluders is copied from there. O(pixels of the
/// boxes around the parts).
Result<Completion> complete_parts(const PartRegions& regions, const Occluders& occluders,
                                  const RunContext& context = {},
                                  std::initializer_list<const Completion*> known = {});

/// Every part with all others as its occluders. O(parts^2).
Occluders all_others(const PartRegions& regions);

/// Compares every two parts that share at least 4 pixel sides. `completion` is that below
/// all_others, and an ellipse is fitted to the contour of each with and without the common
/// boundary. Nothing is `open`. O(pixels of the boxes around the parts + pairs).
Result<std::vector<NeighbourEvidence>> compare_neighbours(const PartRegions& regions,
                                                          const Completion& completion,
                                                          const RunContext& context = {});

}  // namespace relievo::understanding

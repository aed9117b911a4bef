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

/// Cuts off what would be seen of completed parts that are sorted back to front. Each shape keeps
/// its visible part and the region below parts in front of it, in one piece with the visible part.
/// A boundary between its visible part and a part behind it continues below the parts in front.
/// For that, `below_front` has the completions whose occluders are the parts in front only. A pixel
/// must lie in both shapes, unless the one of `below_front` is a membrane, which fits anything, and
/// the other is not. Every part reaches at least `overlap` px below the neighbours in front of it,
/// so that no crack remains between them; a hidden region keeps 2 px away from where its occluders
/// end, so that no two outlines coincide. Shapes that the user gave are kept. O(boxes of the
/// parts).
Completion clip_to_order(const PartRegions& regions, const Completion& completion,
                         const Completion& below_front, int overlap);

}  // namespace relievo::understanding

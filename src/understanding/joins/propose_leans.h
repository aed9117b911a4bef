#pragma once

#include <vector>

#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// Proposes how the trunk leans, which is the largest part, the large parts joined to it and what
/// is enclosed by them. A limb in front of it and its counterpart that comes out from behind it at
/// the other side tell that it is turned. For a trunk whose cross-section is an ellipse with q
/// times as much depth as width and limbs at the ends of its width, turned by theta,
///   r = 1 / sqrt(1 + q^2 tan^2 theta)
/// is the distance between the limbs' roots relative to the width that is seen, and the middle
/// between front and back rises by
///   (1 - q^2) tan theta / (1 + q^2 tan^2 theta) = (1/q - q) r sqrt(1 - r^2)
/// per px towards the near limb: nothing from the front (r = 1) nor from the side (r = 0). q is
/// taken to be 0.8. The drawing is taken to be upright, so that trunks turn about the vertical.
/// `shapes` are those of the parts in the scene. One lean for each part of the trunk, or none.
/// O(sides + pixels of the trunk and its limbs).
std::vector<ProposedLean> propose_leans(const PartRegions& regions, const Stacking& stacking,
                                        const Completion& shapes, const JoinProposals& joining);

/// The rule above, 0 for distances above 1 and, since limbs side by side tell nothing, for those
/// below a quarter.
double lean_of_roots(double relative_distance);

}  // namespace relievo::understanding

#pragma once

#include <vector>

#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// Proposes the tilt of the trunk, which is the largest part, the large parts joined to it and the
/// parts that these enclose. The trunk is turned where a limb in front of it has a counterpart that
/// comes out from behind it at the other side. For a trunk whose cross-section is an ellipse with q
/// times as much depth as width, with limbs at the ends of its width, turned by theta,
///   r = 1 / sqrt(1 + q^2 tan^2 theta)
/// is the distance between the limbs' roots relative to the visible width, and the middle between
/// front and back rises towards the near limb, per px, by
///   (1 - q^2) tan theta / (1 + q^2 tan^2 theta) = (1/q - q) r sqrt(1 - r^2):
/// nothing as seen from the front (r = 1) or the side (r = 0). q is taken to be 0.8. The drawing is
/// taken to be upright, so that trunks turn about the vertical. `regions` are sorted back to front,
/// `order` is that of stack_parts, and `shapes` are those of the parts in the scene. Returns one
/// tilt for each part of the trunk, or none. O(sides + pixels of the trunk and its limbs).
std::vector<ProposedLean> propose_leans(const PartRegions& regions,
                                        const std::vector<OrderArrow>& order,
                                        const Completion& shapes,
                                        const std::vector<ProposedJoin>& joins);

/// The tilt for a relative distance r of the roots by the rule above; 0 above 1 and, since limbs
/// side by side tell nothing, below a quarter.
double lean_of_roots(double relative_distance);

}  // namespace relievo::understanding

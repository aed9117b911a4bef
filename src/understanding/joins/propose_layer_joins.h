#pragma once

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"
#include "understanding/joins/join_proposals.h"

namespace relievo::understanding {

/// Proposes how the parts of a layered drawing connect, from their complete outlines.
///  - join: the part in front is a limb of the one behind. Its outline has one run inside that part
///    (its root), and a good share of the part lies beside it. The join is the cap of the root:
///    around its tip the outline as far as its normal turns by less than 57 degrees (one radian)
///    from the limb's axis, and not longer than 0.65 times the root of the limb's area; of a round
///    part, whose neck is narrower than itself, 0.45 times. The axis is that of the last one and a
///    half widths of the limb, and the tip what is farthest that way; where those are no longer
///    than wide, the tip is what is farthest from the limb's free end, as measured inside it, and
///    the axis the normal there. Each end goes to the nearest of the `anchors` (ends of the curves
///    that the author drew, canvas px) on the outline, by a quarter of the join at most: whoever
///    draws sets them where an outline changes.
///  - equal: what lies inside another part, as an eye does; a limb in front without such a root;
///    and a limb that comes out from behind a larger part, whose outline it touches all along. That
///    is tied to nothing that it crosses behind it as well, and a joined limb to no other part
///    behind it. What nothing holds so hangs on the larger part that hides most of it.
///  - all else is above, as everywhere, and not listed.
/// A limb grows out of one part, in front of it or behind: that with the most confidence, which a
/// clear change of colour halves, and a part that is not larger than the limb. What covers the root
/// of another limb that is not much thicker, as a foot the root of a tail, does not grow out of
/// that, unless limbs grow out of it. What is of a foreign colour is held, and tied, unless it
/// covers much of the other, as hair and clothes do; what is less sure than a quarter is tied as
/// well. What lies mostly on another is a limb of that only where both have one colour. Without
/// `colors` all are alike, but for the last. Shapes are compared on a grid of 512 pixels along the
/// longest side. Near-linear in the points, plus the pixels of parts that overlap, pair by pair.
JoinProposals propose_layer_joins(const Scene& scene, const PartColors& colors = {},
                                  const std::vector<Point2>& anchors = {});

}  // namespace relievo::understanding

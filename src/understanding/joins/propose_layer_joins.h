#pragma once

#include <vector>

#include "relievo/scene.h"
#include "understanding/joins/join_proposals.h"

namespace relievo::understanding {

/// Proposes how the parts of a layered drawing connect, from their complete outlines.
///  - join: the part in front is a limb of the one behind. Its outline has one run inside that
///  part,
///    its root, and a good share of the part lies outside that. The join is the cap of the root:
///    the outline around the limb's tip as far as its normal is within 57 degrees (one radian) of
///    the limb's axis, and not longer than 0.65 times the root of the limb's area, or 0.45 times
///    for a round part, whose neck is narrower than itself. The axis is the main axis of the last
///    one and a half widths of the limb, and the tip is the point farthest along it. Where that end
///    is no longer than wide, the tip is the point farthest from the limb's free end, measured
///    inside the limb, and the axis is the normal there. Each end moves to the nearest of the
///    `anchors` (ends of the curves that the author drew, canvas px) on the outline, by a quarter
///    of the join at most: artists end curves where an outline changes.
///  - equal: a part inside another, as an eye; a limb in front without such a root; and a limb that
///    comes out from behind a larger part and touches its outline all along. The last is tied to no
///    part behind it that it crosses, and a joined limb is tied to no other part behind it. A part
///    without any of these is tied to the larger part that hides most of it.
///  - above: all other pairs, which are not listed.
/// A limb grows out of one part, in front of it or behind: the one with the most confidence, which
/// a clear change of colour halves, as does a part that is not larger than the limb. A part that
/// covers the root of another limb and is not much thinner, as a foot covers the root of a tail,
/// does not grow out of that limb, unless limbs grow out of the part itself. A part of a foreign
/// colour is an object of its own and tied, unless it covers much of the other part, as hair and
/// clothes do; a join with less than a quarter of confidence becomes a tie as well. A part that
/// lies mostly on another is a limb of that only where both have one colour. Without `colors` all
/// colours count as equal, except in the last rule. Shapes are compared on a grid of 512 pixels
/// along the longest side. Near-linear in the points, plus the pixels of parts that overlap, pair
/// by pair.
JoinProposals propose_layer_joins(const Scene& scene, const PartColors& colors = {},
                                  const std::vector<Point2>& anchors = {});

}  // namespace relievo::understanding

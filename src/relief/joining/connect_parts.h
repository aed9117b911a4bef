#pragma once

#include "kernel/geometry/polygon.h"
#include "relief/joining/joining.h"
#include "relievo/scene.h"

namespace relievo {

/// Proposes how the parts of a layered drawing connect, from their complete outlines.
///  - join: the part in front is a limb of the one behind. Its outline has one run inside that part
///    (its root), and a good share of the part lies beside it. The join is the cap of the root:
///    around the point of the run that is farthest from the limb's free end, as measured inside the
///    limb, the outline as far as its normal turns by less than 57 degrees (one radian) from the
///    limb's axis.
///  - equal: what lies inside another part, as an eye does; a limb in front without such a root;
///  and
///    a limb that comes out from behind a larger part, whose outline it touches then all along.
///  - all else is above, as everywhere, and not listed.
/// Shapes are compared on a grid of 512 pixels along the longest side. Near-linear in the points,
/// plus the pixels of parts that overlap, pair by pair.
Joining connect_parts(const Scene& scene);

}  // namespace relievo

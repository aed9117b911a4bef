#pragma once

#include <Eigen/Core>

#include "relief/inflation/inflation.h"
#include "relief/ordering/ordering_system.h"

namespace relievo {

/// The shift by which caps close round what they lie on, #N in scene units, 0 but on them. A cap is
/// a part that grows out of nothing, is tied to one behind it (`equal`, without a range) and covers
/// a run of the outline of that: a hat on a head, a head on a neck. Where it crosses that part it
/// must come as far forward as that, and the whole of it would follow, off the other's outline. So
/// it is wanted at the height of what it is tied to along its own outline, at 0 where nothing lies
/// behind that, and between as a soap film. What grows out of it comes along. It comes
/// gradually, by the shares of the two outlines that lie on each other, and of its own where
/// nothing is behind it. Caps with a lean stay. `metric`: of the shift. O(N + F) where there is no
/// cap, and for each a factorisation on its nodes.
Eigen::VectorXd cap_rise(const SurfaceInput& surface, const Inflation& inflation,
                         const ShiftMetric& metric);

}  // namespace relievo

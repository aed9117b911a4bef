#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/ordering/depth_problem.h"
#include "relief/ordering/shift_metric.h"

namespace relievo {

/// Makes a system one for `pairs` that link no nodes but those which it was built to link: matrix
/// and factor keep their pattern, and what of the factor stays the same need not be computed again.
/// False, and nothing changes, where other nodes are linked. `metric` is that of the system. Costs
/// as making a system does, but for its analysis.
bool select_pairs(const std::vector<int>& node_part, const std::vector<DepthPair>& pairs,
                  const ShiftMetric& metric, DepthSystem& system);

}  // namespace relievo

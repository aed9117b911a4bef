#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/ordering/depth_problem.h"

namespace relievo {

/// Makes a system one for `pairs`, which are some of those that it was built for, by freeing gaps
/// and bounding them again: matrix and factor stay. False, and nothing changes, where the pairs ask
/// for other gaps or other merged nodes than the system has. Costs as build_depth_forest.
bool select_pairs(const std::vector<int>& node_part, const std::vector<DepthPair>& pairs,
                  DepthSystem& system);

}  // namespace relievo

#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/nonlinear/nonlinear_map.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/nonlinear/nonlinear_solution.h"

namespace relievo::relief {

/// What `state` knows of the nodes of the pairs and of B. u_start: #N, scene units.
/// O(pairs log pairs).
std::vector<NonlinearMark> remember(const LayeredMesh& mesh, const NonlinearModel& model,
                                    const std::vector<DepthPair>& pairs,
                                    const Eigen::VectorXd& u_start, const NonlinearState& state);

/// Puts what is known of near nodes of the same part into `state`, whose u is that of the start: u
/// on B, and the loads of the nodes of the pairs and B, which share that of the nearest mark.
/// Leaves parts that are not known as they are. O(pairs log marks) where marks are not stacked
/// above each other on the canvas.
void recall(const LayeredMesh& mesh, const NonlinearModel& model,
            const std::vector<DepthPair>& pairs, const std::vector<NonlinearMark>& marks,
            NonlinearState& state);

}  // namespace relievo::relief

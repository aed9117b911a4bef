#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/nonlinear/nonlinear_map.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/nonlinear/nonlinear_solution.h"

namespace relievo::relief {

/// Returns the marks of `state` at the nodes of the pairs and of B. u_start: #N, scene units.
/// O(pairs log pairs).
std::vector<NonlinearMark> remember(const LayeredMesh& mesh, const NonlinearModel& model,
                                    const std::vector<DepthPair>& pairs,
                                    const Eigen::VectorXd& u_start, const NonlinearState& state);

/// Starts `state`, whose u is that of the start, from marks near its nodes on the same parts: sets
/// u on B, and the loads of the nodes of the pairs and B, among which each mark's load is divided.
/// Nodes of parts without marks keep their values. O(pairs log marks) unless marks are stacked
/// above each other on the canvas.
void recall(const LayeredMesh& mesh, const NonlinearModel& model,
            const std::vector<DepthPair>& pairs, const std::vector<NonlinearMark>& marks,
            NonlinearState& state);

}  // namespace relievo::relief

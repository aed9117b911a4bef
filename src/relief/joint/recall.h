#pragma once

#include <vector>

#include "relief/joint/bound_modes.h"
#include "relief/joint/joint_map.h"
#include "relief/joint/joint_memory.h"
#include "relief/joint/joint_model.h"
#include "relief/layers/layered_mesh.h"

namespace relievo {

/// What `state` knows of the nodes of the pairs and of B. u_start: #N, scene units.
/// O(pairs log pairs).
std::vector<JointMark> remember(const LayeredMesh& mesh, const JointModel& model,
                                const std::vector<DepthPair>& pairs, const Eigen::VectorXd& u_start,
                                const JointState& state);

/// Puts the values of the modes into the marks of B.
void remember(const LayeredMesh& mesh, const JointModel& model, const BoundModes& modes,
              JointMemory& memory);

/// The modes that are known, interpolated along B; 0 on parts that are not known.
BoundModes recall_modes(const LayeredMesh& mesh, const JointModel& model, const JointMemory& known);

/// Puts what is known of near nodes of the same part into `state`, whose u is that of the start: u
/// on B, and the loads of the nodes of the pairs and B, which share that of the nearest mark.
/// Leaves parts that are not known as they are. O(pairs log marks) where marks are not stacked
/// above each other on the canvas.
void recall(const LayeredMesh& mesh, const JointModel& model, const std::vector<DepthPair>& pairs,
            const std::vector<JointMark>& marks, JointState& state);

}  // namespace relievo

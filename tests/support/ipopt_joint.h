#pragma once

#include <optional>

#include "support/joint_program.h"

namespace relievo::testing {

/// Minimises the joint energy by Ipopt with exact derivatives of second order, from `start`;
/// nothing if it does not converge.
std::optional<JointPoint> solve_joint_by_ipopt(const JointProgram& program,
                                               const JointPoint& start);

}  // namespace relievo::testing

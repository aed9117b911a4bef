#pragma once

#include <optional>

#include "support/nonlinear_program.h"

namespace relievo::testing {

/// Minimises the non-linear energy by Ipopt with exact derivatives of second order, from `start`;
/// nothing if it does not converge.
std::optional<NonlinearPoint> solve_joint_by_ipopt(const NonlinearProgram& program,
                                                   const NonlinearPoint& start);

}  // namespace relievo::testing

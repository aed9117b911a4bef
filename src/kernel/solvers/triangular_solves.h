#pragma once

#include <Eigen/Core>

#include "kernel/solvers/factor_memory.h"

namespace relievo {

/// y := L^-1 y, in the order of elimination. The tasks' contributions to the columns above them
/// are summed in the order of the tasks, so that threads change no bit.
void solve_forward(const FactorMemory& factor, Eigen::VectorXd& y);

/// y := L^-T y, likewise.
void solve_backward(const FactorMemory& factor, Eigen::VectorXd& y);

}  // namespace relievo

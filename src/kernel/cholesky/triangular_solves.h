#pragma once

#include <Eigen/Core>

#include "kernel/cholesky/factor_memory.h"

namespace relievo {

/// Computes L^-1 b in the order of elimination; b is by row of the matrix. Skips fronts to which
/// only zeros come, as where b is local. Sums the contributions of the tasks to the columns above
/// them in the order of the tasks, so that threads change no bit. O(entries of L).
Eigen::VectorXd solve_forward(const FactorMemory& factor, const Eigen::VectorXd& b);

/// Computes L'^-1 y by row of the matrix; y is in the order of elimination. O(entries of L).
Eigen::VectorXd solve_backward(const FactorMemory& factor, Eigen::VectorXd y);

}  // namespace relievo

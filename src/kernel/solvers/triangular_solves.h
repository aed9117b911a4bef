#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/solvers/factor_memory.h"
#include "kernel/solvers/sparse_cholesky.h"

namespace relievo {

/// L^-1 b, in the order of elimination; b is by row of the matrix. The tasks' contributions to the
/// columns above them are summed in the order of the tasks, so that threads change no bit.
Eigen::VectorXd solve_forward(const FactorMemory& factor, const Eigen::VectorXd& b);

/// The same with the same bits; tasks whose version (one each) and right-hand side are those of
/// `last` are not solved again. Leaves this sweep there.
Eigen::VectorXd solve_forward(const FactorMemory& factor, const Eigen::VectorXd& b,
                              const std::vector<uint64_t>& version, ForwardSweep& last);

/// L^-T y by row of the matrix, likewise.
Eigen::VectorXd solve_backward(const FactorMemory& factor, Eigen::VectorXd y);

}  // namespace relievo

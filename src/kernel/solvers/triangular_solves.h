#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/solvers/factor_memory.h"
#include "kernel/solvers/forward_sweep.h"

namespace relievo {

/// y := L^-1 y, in the order of elimination. The tasks' contributions to the columns above them
/// are summed in the order of the tasks, so that threads change no bit.
void solve_forward(const FactorMemory& factor, Eigen::VectorXd& y);

/// The same with the same bits; tasks whose version (one each) and right-hand side are those of
/// `last` are not solved again. Leaves this sweep there.
void solve_forward(const FactorMemory& factor, const std::vector<uint64_t>& version,
                   ForwardSweep& last, Eigen::VectorXd& y);

/// y := L^-T y, likewise.
void solve_backward(const FactorMemory& factor, Eigen::VectorXd& y);

}  // namespace relievo

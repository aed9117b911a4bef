#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <vector>

#include "kernel/cholesky/front_layout.h"
#include "kernel/cholesky/frontal_kernels.h"
#include "kernel/cholesky/sparse_cholesky.h"

namespace relievo {

/// panel := its columns of the Cholesky factor, update -= what they contribute to the rest.
/// False when a pivot is not positive, or as soon as `stop`, which may be null, is set. Cuts large
/// fronts into tasks, which changes no bit: each entry is computed by one of them.
bool eliminate_front(const FrontalKernels& kernels, const Front& front,
                     const std::atomic<bool>* stop);

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

#pragma once

#include <Eigen/Core>
#include <span>

#include "kernel/solvers/factor_memory.h"

namespace relievo {

/// What is left of a factorised matrix on some rows once all others are eliminated, which they were
/// before those of `rows` that they meet. #rows x #rows, symmetric. O(fronts + #rows^3) at most.
Eigen::MatrixXd schur_complement(const FactorMemory& factor, std::span<const int> rows);

}  // namespace relievo

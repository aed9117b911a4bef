#pragma once

#include <Eigen/Core>

#include "kernel/base/sparse_matrix.h"

namespace relievo {

/// y = A x for a symmetric A of which only the lower triangle is stored. O(entries), on all
/// workers where there are many.
Eigen::VectorXd multiply_symmetric(const SparseMatrix& lower, const Eigen::VectorXd& x);

}  // namespace relievo

#pragma once

#include <Eigen/Core>

#include "kernel/base/sparse_matrix.h"
#include "kernel/solvers/symmetric_graph.h"

namespace relievo {

/// y = A x for a symmetric A of which only the lower triangle is stored. O(entries), on all
/// workers where there are many.
Eigen::VectorXd multiply_symmetric(const SparseMatrix& lower, const Eigen::VectorXd& x);

/// Row i of A times x; `graph` is that of A's lower triangle. O(entries of the row).
double multiply_row(const SparseMatrix& lower, const SymmetricGraph& graph, int i,
                    const Eigen::VectorXd& x);

/// A'x, or A x for a symmetric A of which both triangles are stored. O(entries), on all workers.
Eigen::VectorXd multiply_transposed(const SparseMatrix& A, const Eigen::VectorXd& x);

}  // namespace relievo

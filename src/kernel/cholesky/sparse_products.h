#pragma once

#include <Eigen/Core>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/symmetric_graph.h"

namespace relievo {

/// Computes A x for a symmetric A of which only the lower triangle is stored. O(entries), on all
/// workers where there are many. Threads change no bit.
Eigen::VectorXd multiply_symmetric(const SparseMatrix& lower, const Eigen::VectorXd& x);

/// Computes row i of A times x for a symmetric A of which only the lower triangle is stored;
/// `graph` is that of A. Precondition: the diagonal entry is stored. O(entries of the row).
double multiply_row(const SparseMatrix& lower, const SymmetricGraph& graph, int i,
                    const Eigen::VectorXd& x);

/// Computes A'x; it is A x for a symmetric A of which both triangles are stored. O(entries), on all
/// workers.
Eigen::VectorXd multiply_transposed(const SparseMatrix& A, const Eigen::VectorXd& x);

}  // namespace relievo

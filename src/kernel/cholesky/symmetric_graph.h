#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/sparse_matrix.h"

namespace relievo {

/// The off-diagonal entries of a symmetric matrix, each at both of its ends: those of row i are
/// entries begin[i] .. begin[i + 1] - 1.
struct SymmetricGraph {
  std::vector<int> begin;      ///< #n + 1
  std::vector<int> neighbour;  ///< row at the other end
  std::vector<int> source;     ///< index into the values of the matrix

  int size() const { return static_cast<int>(begin.size()) - 1; }
};

/// Reads the strictly lower triangle of a compressed matrix. O(n + entries).
SymmetricGraph make_symmetric_graph(const SparseMatrix& lower);

/// Rows at most `steps` edges from the seeds, ascending. Those with left_out[i] != 0 (none, or #n
/// flags) are not among them, and lead to no others. O(n + edges around the seeds).
std::vector<int> rows_around(const SymmetricGraph& graph, std::span<const int> seeds, int steps,
                             std::span<const uint8_t> left_out = {});

/// Where each row comes in an order: the inverse of a permutation.
std::vector<int> positions_in(const std::vector<int>& order);

/// y = A x for a symmetric A of which only the lower triangle is stored. O(entries), on all
/// workers where there are many.
Eigen::VectorXd multiply_symmetric(const SparseMatrix& lower, const Eigen::VectorXd& x);

/// Row i of A times x; `graph` is that of A's lower triangle. O(entries of the row).
double multiply_row(const SparseMatrix& lower, const SymmetricGraph& graph, int i,
                    const Eigen::VectorXd& x);

/// A'x, or A x for a symmetric A of which both triangles are stored. O(entries), on all workers.
Eigen::VectorXd multiply_transposed(const SparseMatrix& A, const Eigen::VectorXd& x);

}  // namespace relievo

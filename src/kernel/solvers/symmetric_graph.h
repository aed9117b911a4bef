#pragma once

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

/// Where each row comes in an order: the inverse of a permutation.
std::vector<int> positions_in(const std::vector<int>& order);

}  // namespace relievo

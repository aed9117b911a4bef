#pragma once

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

}  // namespace relievo

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/sparse_matrix.h"

namespace relievo {

/// The off-diagonal entries of a symmetric matrix as a graph, each entry at both of its ends: those
/// of row i are the entries begin[i] .. begin[i + 1] - 1.
struct SymmetricGraph {
  std::vector<int> begin;      ///< #n + 1
  std::vector<int> neighbour;  ///< row at the other end
  std::vector<int> source;     ///< index into the values of the matrix

  int size() const { return static_cast<int>(begin.size()) - 1; }
};

/// Makes the graph from the strictly lower triangle of a compressed matrix. O(n + entries).
SymmetricGraph make_symmetric_graph(const SparseMatrix& lower);

/// Lists the rows at most `steps` edges from the seeds, ascending. Paths do not pass through rows
/// with left_out[i] != 0 (empty, or #n flags), which are not listed. O(n + edges around the seeds).
std::vector<int> rows_around(const SymmetricGraph& graph, std::span<const int> seeds, int steps,
                             std::span<const uint8_t> left_out = {});

/// Computes the position of each row in an order: the inverse permutation. O(n).
std::vector<int> positions_in(const std::vector<int>& order);

}  // namespace relievo

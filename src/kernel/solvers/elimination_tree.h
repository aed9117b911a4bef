#pragma once

#include <vector>

#include "kernel/solvers/symmetric_graph.h"

namespace relievo {

/// Parent of each column in the elimination tree of a symmetric matrix, -1 at roots. Columns count
/// in the order of elimination. Near-linear in the entries (Liu 1990, with path compression).
std::vector<int> elimination_tree(const SymmetricGraph& graph, const std::vector<int>& order);

/// The columns of a forest, children before parents and every subtree in one run. `parent` is
/// larger than the child wherever it is not -1. O(n).
std::vector<int> postorder(const std::vector<int>& parent);

/// Entries in each column of the Cholesky factor, diagonal included. The order is a postorder of
/// its tree `parent`: postorder(parent) would be the identity.
/// Near-linear in the entries of the matrix (Gilbert, Ng and Peyton 1994).
std::vector<int> column_counts(const SymmetricGraph& graph, const std::vector<int>& order,
                               const std::vector<int>& parent);

}  // namespace relievo

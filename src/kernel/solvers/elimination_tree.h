#pragma once

#include <vector>

namespace relievo {

/// One strict triangle of a symmetric pattern as flat arrays: column j links to
/// index[begin[j]] .. index[begin[j + 1] - 1].
struct TrianglePattern {
  std::vector<int> begin;  ///< #n + 1
  std::vector<int> index;

  int size() const { return static_cast<int>(begin.size()) - 1; }
};

/// Parent of each column in the elimination tree of a symmetric matrix, -1 at roots, from the rows
/// above the diagonal of each column. Near-linear in the entries (Liu 1990, with path compression).
std::vector<int> elimination_tree(const TrianglePattern& upper);

/// The columns of a forest, children before parents and every subtree in one run. `parent` is
/// larger than the child wherever it is not -1. O(n).
std::vector<int> postorder(const std::vector<int>& parent);

/// Entries in each column of the Cholesky factor, diagonal included, from the rows below the
/// diagonal of each column. `parent` is postordered: postorder() would be the identity.
/// Near-linear in the entries of the matrix (Gilbert, Ng and Peyton 1994).
std::vector<int> column_counts(const TrianglePattern& lower, const std::vector<int>& parent);

}  // namespace relievo

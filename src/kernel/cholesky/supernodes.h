#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/cholesky/symmetric_graph.h"
#include "relievo/run_context.h"

namespace relievo {

/// The columns of a Cholesky factor in groups, the fronts: dense trapezoids whose columns share one
/// row structure. Columns and rows are numbered in the order of elimination. Children come before
/// parents, and each subtree is one range of fronts.
struct Supernodes {
  std::vector<int> order;               ///< #n: row of the matrix of each column
  std::vector<int> column_begin;        ///< #S + 1: first column of each front
  std::vector<int> parent;              ///< #S: parent of each front, -1 at roots
  std::vector<Eigen::Index> row_begin;  ///< #S + 1, into row
  std::vector<int> row;                 ///< rows of each front, ascending, its own columns first

  int size() const { return static_cast<int>(parent.size()); }
  int columns(int front) const { return column_begin[front + 1] - column_begin[front]; }
  int rows(int front) const { return static_cast<int>(row_begin[front + 1] - row_begin[front]); }
};

/// Groups the columns of the factor of a matrix that is eliminated in a postorder of the given
/// order. Merges maximal supernodes with their parents as long as few zeros are stored for it
/// [Davis, Direct Methods for Sparse Linear Systems, 2006; Ashcraft and Grimes 1989]. The result is
/// unusable where `context` is cancelled. Near-linear in the entries and the rows of the fronts.
Supernodes make_supernodes(const SymmetricGraph& graph, const std::vector<int>& order,
                           const RunContext& context = {});

/// Computes the parent of each column in the elimination tree of a symmetric matrix, -1 at roots
/// (Liu 1990, with path compression). Columns are numbered in the order of elimination. Near-linear
/// in the entries.
std::vector<int> elimination_tree(const SymmetricGraph& graph, const std::vector<int>& order);

/// Returns the columns of a forest in postorder: children before parents and each subtree in one
/// range. Precondition: parent[j] > j or parent[j] = -1. O(n).
std::vector<int> postorder(const std::vector<int>& parent);

/// Counts the entries in each column of the Cholesky factor, diagonal included (Gilbert, Ng and
/// Peyton 1994). Precondition: the order is a postorder of its tree `parent`, so that
/// postorder(parent) is the identity. Near-linear in the entries of the matrix.
std::vector<int> column_counts(const SymmetricGraph& graph, const std::vector<int>& order,
                               const std::vector<int>& parent);

}  // namespace relievo

#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/cholesky/symmetric_graph.h"
#include "relievo/run_context.h"

namespace relievo {

/// The columns of a Cholesky factor grouped into fronts: dense trapezoids whose columns share one
/// row structure. Columns and rows count in the order of elimination; children come before parents
/// and each subtree is one run of fronts.
struct Supernodes {
  std::vector<int> order;               ///< #n: original index of each column
  std::vector<int> column_begin;        ///< #S + 1: first column of each front
  std::vector<int> parent;              ///< #S, -1 at roots
  std::vector<Eigen::Index> row_begin;  ///< #S + 1
  std::vector<int> row;                 ///< rows of each front, ascending, its own columns first

  int size() const { return static_cast<int>(parent.size()); }
  int columns(int front) const { return column_begin[front + 1] - column_begin[front]; }
  int rows(int front) const { return static_cast<int>(row_begin[front + 1] - row_begin[front]); }
};

/// Groups the columns of the factor of a matrix that is eliminated in a postorder of the given
/// order. Maximal supernodes are merged with their parents as long as the
/// zeros this stores remain few [Davis, Direct Methods for Sparse Linear Systems, 2006;
/// Ashcraft and Grimes 1989]. Near-linear in the entries and the rows of the fronts. Of no
/// use where `context` is cancelled.
Supernodes make_supernodes(const SymmetricGraph& graph, const std::vector<int>& order,
                           const RunContext& context = {});

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

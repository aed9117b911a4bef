#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/frontal_kernels.h"
#include "kernel/cholesky/supernodes.h"
#include "kernel/cholesky/symmetric_graph.h"

namespace relievo {

/// An entry of the matrix and its place in the panel of its front.
struct PanelEntry {
  int source = -1;          ///< index into the values of the matrix
  Eigen::Index target = 0;  ///< index into the panel
};

/// The schedule and the memory layout of a factorisation, so that it searches for nothing. The tree
/// of fronts is divided into tasks, which are independent of each other, and the top fronts, which
/// wait for all tasks.
///
/// A task has two stacks for the updates of its fronts, one for those at even depth in the tree and
/// one for those at odd depth: the updates of the children of a front are the last ones of one
/// stack, and its own goes on the other. Updates that leave a task, and those of the top fronts,
/// have places of their own, and so have all updates of an incremental layout.
struct FrontLayout {
  Supernodes fronts;
  std::vector<Range> tasks;  ///< ascending ranges of fronts, each of whole subtrees
  std::vector<int> top;      ///< fronts in no task, ascending
  /// The top fronts by level, children on lower levels: all of a level are independent.
  std::vector<std::vector<int>> top_levels;
  std::vector<int> top_column;  ///< #n: index of each column among those of top fronts, or -1
  int top_columns = 0;          ///< number of columns of top fronts
  std::vector<int> front_of;    ///< #n: front that eliminates each row of the matrix
  std::vector<Eigen::Index> panel_begin;   ///< #S + 1, in doubles
  std::vector<Eigen::Index> update_begin;  ///< #S, in doubles
  Eigen::Index updates_size = 0;           ///< room for all updates that live at once, in doubles
  std::vector<int> first_child;            ///< #S, -1 if there is none
  std::vector<int> next_sibling;           ///< #S, ascending, -1 at the last
  std::vector<int> row_in_parent;         ///< for each of fronts.row its index in the parent, or -1
  std::vector<Eigen::Index> entry_begin;  ///< #S + 1, into entries
  std::vector<PanelEntry> entries;        ///< of the matrix, front by front
  int most_rows = 0;                      ///< largest number of rows of a front
};

/// Lays out the factorisation of matrices with the pattern of A, from whose `graph` the fronts were
/// made. With `keep_updates` each update has a place of its own, so that single fronts can be
/// computed again. Near-linear in the entries and the rows of the fronts.
FrontLayout lay_out(const SparseMatrix& A, const SymmetricGraph& graph, Supernodes fronts,
                    bool keep_updates);

}  // namespace relievo

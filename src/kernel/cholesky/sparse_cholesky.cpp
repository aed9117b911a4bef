#include "kernel/cholesky/sparse_cholesky.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <atomic>
#include <cassert>
#include <utility>
#include <vector>

#include "kernel/base/workers.h"
#include "kernel/cholesky/eliminate_front.h"
#include "kernel/cholesky/factor_memory.h"
#include "kernel/cholesky/triangular_solves.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<int> fill_reducing_order(const SparseMatrix& A) {
  if (A.rows() == 0) return {};
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(A.selfadjointView<Eigen::Lower>(), permutation);
  return {permutation.indices().begin(), permutation.indices().end()};
}

/// Flags the ancestors of the flagged fronts; `flags` has #S entries.
void flag_ancestors(const Supernodes& fronts, std::vector<uint8_t>& flags) {
  for (int s = 0; s < fronts.size(); ++s)
    if (flags[s] != 0 && fronts.parent[s] >= 0) flags[fronts.parent[s]] = 1;
}

/// Adds the update of `child` to its parent (extend-add); rows[i] is the row of the parent for row
/// i of the child.
void add_update(const Front& child, const int* rows, const Front& parent) {
  for (int j = child.columns; j < child.rows; ++j) {
    const double* from = child.column(j);
    double* to = parent.column(rows[j]);
    for (int i = j; i < child.rows; ++i) to[rows[i]] += from[i];
  }
}

/// Adds the lower triangle of x x' to S.
void add_outer_product(const VectorXd& x, MatrixXd& S) {
  for (Index j = 0; j < x.size(); ++j) {
    const double factor = x[j];
    if (factor == 0) continue;
    double* column = S.col(j).data();
    for (Index i = j; i < x.size(); ++i) column[i] += factor * x[i];
  }
}

/// Numbers the columns of `rows` in the order of elimination; -1 for all other columns of the
/// factor.
std::vector<int> places_of(const FactorMemory& factor, std::span<const int> rows) {
  const std::vector<int>& order = factor.layout.fronts.order;
  std::vector<uint8_t> wanted(order.size(), 0);
  for (const int row : rows) wanted[row] = 1;
  std::vector<int> places(order.size(), -1);
  int next = 0;
  for (size_t c = 0; c < order.size(); ++c)
    if (wanted[order[c]] != 0) places[c] = next++;
  return places;
}

/// Computes the lower triangle of L L' for the rows and columns of the factor L that are numbered.
MatrixXd product_of(const FactorMemory& factor, const std::vector<int>& places, Index size) {
  const Supernodes& fronts = factor.layout.fronts;
  MatrixXd S = MatrixXd::Zero(size, size);
  VectorXd column(size);
  for (int s = 0; s < fronts.size(); ++s) {
    const Front front = factor.front(s);
    const int* row = factor.rows(s);
    for (int c = 0; c < front.columns; ++c) {
      if (places[row[c]] < 0) continue;
      column.setZero();
      for (int i = c; i < front.rows; ++i) {
        assert(places[row[i]] >= 0 || front.column(c)[i] == 0);
        if (places[row[i]] >= 0) column[places[row[i]]] = front.column(c)[i];
      }
      add_outer_product(column, S);
    }
  }
  return S;
}

}  // namespace

struct SparseCholesky::Implementation {
  FactorMemory memory;
  bool incremental = false;
  SymmetricGraph graph;           ///< of the pattern, if incremental
  std::vector<double> values;     ///< of the last factorisation, with fixed rows replaced; or empty
  std::vector<uint8_t> outdated;  ///< #S: fronts to be computed

  /// Sums the entries of the matrix and the updates of the children in front s.
  void assemble(int s, const Front& target) const {
    const FrontLayout& layout = memory.layout;
    std::fill(target.panel, target.panel + target.stride() * target.columns, 0.0);
    std::fill(target.update, target.update + target.update_size(), 0.0);
    for (Index e = layout.entry_begin[s]; e < layout.entry_begin[s + 1]; ++e)
      target.panel[layout.entries[e].target] = values[layout.entries[e].source];
    for (int child = layout.first_child[s]; child >= 0; child = layout.next_sibling[child])
      add_update(memory.front(child), layout.row_in_parent.data() + layout.fronts.row_begin[child],
                 target);
  }

  /// Computes front s if it is outdated. Returns false where a pivot is not positive, or `context`
  /// is cancelled.
  bool update_front(int s, const RunContext& context) const {
    if (outdated[s] == 0) return true;
    const Front target = memory.front(s);
    assemble(s, target);
    return eliminate_front(best_kernels(), target, context.cancel);
  }

  /// Computes the outdated fronts and their ancestors.
  bool factorise_outdated(const RunContext& context) {
    const FrontLayout& layout = memory.layout;
    flag_ancestors(layout.fronts, outdated);
    std::atomic<bool> sound{true};
    const auto update = [&](int s) {
      if (context.cancelled() || !update_front(s, context)) sound = false;
      return sound.load(std::memory_order_relaxed);
    };
    run_tasks(static_cast<int>(layout.tasks.size()), [&](int t) {
      for (int s = layout.tasks[t].begin; s < layout.tasks[t].end; ++s)
        if (!update(s)) return;
    });
    for (const std::vector<int>& level : layout.top_levels)
      run_tasks(sound ? static_cast<int>(level.size()) : 0, [&](int i) { update(level[i]); });
    if (!sound || !incremental) values.clear();
    return sound;
  }

  /// Copies the values of A, with fixed rows and columns as those of the identity. All fronts
  /// become outdated.
  void take_values(const SparseMatrix& A, std::span<const uint8_t> fixed) {
    values.resize(static_cast<size_t>(A.outerIndexPtr()[A.outerSize()]));
    outdated.assign(memory.layout.fronts.parent.size(), 1);
    run_ranges(static_cast<int>(A.outerSize()), [&](int first, int last) {
      for (int j = first; j < last; ++j)
        for (int e = A.outerIndexPtr()[j]; e < A.outerIndexPtr()[j + 1]; ++e)
          values[e] = value_of(A, fixed, A.innerIndexPtr()[e], j, e);
    });
  }

  /// Copies the values of A likewise. Only the fronts of entries that differ become outdated.
  void take_changed_values(const SparseMatrix& A, std::span<const uint8_t> fixed) {
    const std::vector<int>& front_of = memory.layout.front_of;
    outdated.assign(outdated.size(), 0);
    for (int j = 0; j < A.outerSize(); ++j)
      for (int e = A.outerIndexPtr()[j]; e < A.outerIndexPtr()[j + 1]; ++e) {
        const int i = A.innerIndexPtr()[e];
        const double value = value_of(A, fixed, i, j, e);
        if (i < j || value == values[e]) continue;
        values[e] = value;
        outdated[std::min(front_of[i], front_of[j])] = 1;
      }
  }

  /// Returns entry e of the matrix, at (i, j). Zeros lose their sign, so that equal values have
  /// equal bits.
  static double value_of(const SparseMatrix& A, std::span<const uint8_t> fixed, int i, int j,
                         int e) {
    if (!fixed.empty() && (fixed[i] != 0 || fixed[j] != 0)) return i == j ? 1 : 0;
    return A.valuePtr()[e] == 0 ? 0 : A.valuePtr()[e];
  }
};

SparseCholesky::SparseCholesky() : implementation_(std::make_unique<Implementation>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

bool SparseCholesky::analyse(const SparseMatrix& A, Refactorisation refactorisation,
                             std::span<const int> order, const RunContext& context) {
  assert(A.isCompressed());
  assert(order.empty() || static_cast<Index>(order.size()) == A.rows());
  Implementation& self = *implementation_;
  self.incremental = refactorisation == Refactorisation::incremental;
  self.values.clear();
  self.memory.layout = {};
  self.graph = {};
  SymmetricGraph graph = make_symmetric_graph(A);
  const std::vector<int> chosen =
      order.empty() ? fill_reducing_order(A) : std::vector<int>(order.begin(), order.end());
  Supernodes fronts = make_supernodes(graph, chosen, context);
  if (context.cancelled()) return false;
  self.memory.layout = lay_out(A, graph, std::move(fronts), self.incremental);
  self.memory.make_room();
  if (self.incremental) self.graph = std::move(graph);
  return true;
}

Index SparseCholesky::factor_entries() const {
  const Supernodes& fronts = implementation_->memory.layout.fronts;
  Index entries = 0;
  for (int s = 0; s < fronts.size(); ++s)
    for (int c = 0; c < fronts.columns(s); ++c) entries += fronts.rows(s) - c;
  return entries;
}

bool SparseCholesky::factorise(const SparseMatrix& A, std::span<const uint8_t> fixed,
                               const RunContext& context) {
  Implementation& self = *implementation_;
  assert(A.isCompressed());
  assert(A.rows() == static_cast<Index>(self.memory.layout.fronts.order.size()));
  assert(fixed.empty() || static_cast<Index>(fixed.size()) == A.rows());
  self.take_values(A, fixed);
  return self.factorise_outdated(context);
}

bool SparseCholesky::refactorise(const SparseMatrix& A, std::span<const uint8_t> fixed,
                                 const RunContext& context) {
  Implementation& self = *implementation_;
  if (self.values.empty()) return factorise(A, fixed, context);
  assert(A.isCompressed());
  assert(fixed.empty() || static_cast<Index>(fixed.size()) == A.rows());
  assert(self.values.size() == static_cast<size_t>(A.outerIndexPtr()[A.outerSize()]));
  self.take_changed_values(A, fixed);
  return self.factorise_outdated(context);
}

const SymmetricGraph& SparseCholesky::graph() const { return implementation_->graph; }

VectorXd SparseCholesky::solve(const VectorXd& b) const {
  const FactorMemory& factor = implementation_->memory;
  return solve_backward(factor, solve_forward(factor, b));
}

MatrixXd SparseCholesky::schur_complement(std::span<const int> rows) const {
  const FactorMemory& factor = implementation_->memory;
  const std::vector<int> places = places_of(factor, rows);
  const auto size = static_cast<Index>(rows.size());
  const MatrixXd S = product_of(factor, places, size);
  const std::vector<int> position = positions_in(factor.layout.fronts.order);
  MatrixXd result(size, size);
  for (Index j = 0; j < size; ++j)
    for (Index i = 0; i < size; ++i) {
      const auto [low, high] = std::minmax(places[position[rows[i]]], places[position[rows[j]]]);
      result(i, j) = S(high, low);
    }
  return result;
}

SparseMatrix lower_block(const SparseMatrix& A, const std::vector<int>& place, int size) {
  SparseMatrix block(size, size);
  block.reserve(A.nonZeros() / 2 + size);
  for (int j = 0; j < A.outerSize(); ++j) {
    if (place[j] < 0) continue;
    block.startVec(place[j]);
    for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry) {
      const int i = static_cast<int>(entry.row());
      if (i >= j && place[i] >= 0) block.insertBack(place[i], place[j]) = entry.value();
    }
  }
  block.finalize();
  return block;
}

std::vector<int> order_of_places(const std::vector<int>& order, const std::vector<int>& place) {
  std::vector<int> places;
  places.reserve(order.size());
  for (const int n : order)
    if (place[n] >= 0) places.push_back(place[n]);
  return places;
}

}  // namespace relievo

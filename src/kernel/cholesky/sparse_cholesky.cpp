#include "kernel/cholesky/sparse_cholesky.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <atomic>
#include <cassert>
#include <utility>
#include <vector>

#include "kernel/base/workers.h"
#include "kernel/cholesky/front_layout.h"
#include "kernel/cholesky/front_numerics.h"

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

/// Of the fronts that are flagged, one flag each.
void flag_ancestors(const Supernodes& fronts, std::vector<uint8_t>& flags) {
  for (int s = 0; s < fronts.size(); ++s)
    if (flags[s] != 0 && fronts.parent[s] >= 0) flags[fronts.parent[s]] = 1;
}

/// Adds the update of `child` to its parent; rows[i] is the parent's row of the child's row i.
void add_update(const Front& child, const int* rows, const Front& parent) {
  for (int j = child.columns; j < child.rows; ++j) {
    const double* from = child.column(j);
    double* to = parent.column(rows[j]);
    for (int i = j; i < child.rows; ++i) to[rows[i]] += from[i];
  }
}

/// The lower triangle of S += x x'.
void add_outer_product(const VectorXd& x, MatrixXd& S) {
  for (Index j = 0; j < x.size(); ++j) {
    const double factor = x[j];
    if (factor == 0) continue;
    double* column = S.col(j).data();
    for (Index i = j; i < x.size(); ++i) column[i] += factor * x[i];
  }
}

/// One per column of the factor: its place among those of `rows`, by elimination, or -1.
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

/// L L' of the wanted rows and columns of the factor L, by elimination.
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
  SymmetricGraph graph;             ///< if incremental
  std::vector<double> values;       ///< of the last factorisation, fixed rows replaced
  std::vector<uint8_t> last_fixed;  ///< #n, of the last factorisation
  std::vector<uint8_t> outdated;    ///< #S
  uint64_t factorisations = 0;
  std::vector<uint64_t> version;  ///< of each task: the last factorisation that changed it

  /// Sums the matrix's entries and the children's updates.
  void assemble(int s, const Front& target, const double* entries) const {
    const FrontLayout& layout = memory.layout;
    std::fill(target.panel, target.panel + target.stride() * target.columns, 0.0);
    std::fill(target.update, target.update + target.update_size(), 0.0);
    for (Index e = layout.entry_begin[s]; e < layout.entry_begin[s + 1]; ++e)
      target.panel[layout.entries[e].target] = entries[layout.entries[e].source];
    for (int child = layout.first_child[s]; child >= 0; child = layout.next_sibling[child])
      add_update(memory.front(child), layout.row_in_parent.data() + layout.fronts.row_begin[child],
                 target);
  }

  /// Computes a front if it is out of date; false where a pivot is not positive, or when
  /// `context` is cancelled.
  bool update_front(int s, const double* entries, const RunContext& context) const {
    if (outdated[s] == 0) return true;
    const Front target = memory.front(s);
    assemble(s, target, entries);
    return eliminate_front(best_kernels(), target, context.cancel);
  }

  /// Computes the fronts that are out of date and those that depend on them.
  bool factorise_outdated(const double* entries, const RunContext& context) {
    if (std::find(outdated.begin(), outdated.end(), 1) == outdated.end()) return true;
    const Supernodes& fronts = memory.layout.fronts;
    flag_ancestors(fronts, outdated);
    const FrontTasks& tasks = memory.layout.tasks;
    ++factorisations;
    version.resize(tasks.tasks.size(), factorisations);
    std::atomic<bool> sound{true};
    const auto update = [&](int s) {
      if (context.cancelled() || !update_front(s, entries, context)) sound = false;
      return sound.load(std::memory_order_relaxed);
    };
    run_tasks(static_cast<int>(tasks.tasks.size()), [&](int t) {
      const auto [first, last] = tasks.tasks[t];
      if (std::find(&outdated[first], &outdated[last], 1) != &outdated[last])
        version[t] = factorisations;
      for (int s = first; s < last; ++s)
        if (!update(s)) return;
    });
    for (const std::vector<int>& level : tasks.top_levels)
      run_tasks(sound ? static_cast<int>(level.size()) : 0, [&](int i) { update(level[i]); });
    return sound;
  }

  void take_flags(const SparseMatrix& A, std::span<const uint8_t> fixed) {
    assert(A.isCompressed());
    last_fixed.assign(fixed.begin(), fixed.end());
    last_fixed.resize(static_cast<size_t>(A.rows()), 0);
  }

  /// Takes over the values of A, with fixed rows and columns as those of the identity. All fronts
  /// are out of date.
  void take_values(const SparseMatrix& A, std::span<const uint8_t> fixed) {
    take_flags(A, fixed);
    values.resize(static_cast<size_t>(A.outerIndexPtr()[A.outerSize()]));
    outdated.assign(memory.layout.fronts.parent.size(), 1);
    run_ranges(static_cast<int>(A.outerSize()), [&](int first, int last) {
      for (int j = first; j < last; ++j)
        for (int e = A.outerIndexPtr()[j]; e < A.outerIndexPtr()[j + 1]; ++e)
          values[e] = value_of(A, A.innerIndexPtr()[e], j, e);
    });
  }

  /// The same, but only fronts that hold entries which differ from the last ones are out of date.
  void take_changed_values(const SparseMatrix& A, std::span<const uint8_t> fixed) {
    take_flags(A, fixed);
    for (int j = 0; j < A.outerSize(); ++j)
      for (int e = A.outerIndexPtr()[j]; e < A.outerIndexPtr()[j + 1]; ++e)
        if (A.innerIndexPtr()[e] >= j) take_value(A, A.innerIndexPtr()[e], j, e);
  }

  /// The same where nothing but `fixed` differs.
  void take_fixed(const SparseMatrix& A, std::span<const uint8_t> fixed) {
    std::vector<int> changed;
    for (int j = 0; j < A.outerSize(); ++j)
      if (last_fixed[j] != fixed[j]) changed.push_back(j);
    for (const int j : changed) last_fixed[j] = fixed[j];
    for (const int j : changed) {
      const int* row = A.innerIndexPtr();
      const int diagonal = static_cast<int>(
          std::lower_bound(row + A.outerIndexPtr()[j], row + A.outerIndexPtr()[j + 1], j) - row);
      assert(row[diagonal] == j);
      take_value(A, j, j, diagonal);
      for (int p = graph.begin[j]; p < graph.begin[j + 1]; ++p)
        take_value(A, graph.neighbour[p], j, graph.source[p]);
    }
  }

  /// Entry e of the matrix, at (i, j) or (j, i). Zeros have no sign, for the same bits ever after.
  double value_of(const SparseMatrix& A, int i, int j, int e) const {
    if (last_fixed[i] != 0 || last_fixed[j] != 0) return i == j ? 1 : 0;
    return A.valuePtr()[e] == 0 ? 0 : A.valuePtr()[e];
  }

  void take_value(const SparseMatrix& A, int i, int j, int e) {
    const double next = value_of(A, i, j, e);
    if (next == values[e]) return;
    values[e] = next;
    outdated[std::min(memory.layout.front_of[i], memory.layout.front_of[j])] = 1;
  }

  bool factorise_changed(const RunContext& context) {
    const bool sound = factorise_outdated(values.data(), context);
    if (!sound || !incremental) values.clear();
    return sound;
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
  self.version.clear();
  SymmetricGraph graph = make_symmetric_graph(A);
  const std::vector<int> chosen =
      order.empty() ? fill_reducing_order(A) : std::vector<int>(order.begin(), order.end());
  Supernodes fronts = make_supernodes(graph, chosen, context);
  if (context.cancelled()) return false;
  self.memory.layout =
      lay_out(A, graph, std::move(fronts), self.incremental ? Updates::kept : Updates::stacked);
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
  assert(A.rows() == static_cast<Index>(self.memory.layout.fronts.order.size()));
  assert(fixed.empty() || static_cast<Index>(fixed.size()) == A.rows());
  self.take_values(A, fixed);
  return self.factorise_changed(context);
}

bool SparseCholesky::refactorise(const SparseMatrix& A, std::span<const uint8_t> fixed,
                                 const RunContext& context) {
  Implementation& self = *implementation_;
  if (self.values.empty()) return factorise(A, fixed, context);
  assert(self.values.size() == static_cast<size_t>(A.outerIndexPtr()[A.outerSize()]));
  self.outdated.assign(self.outdated.size(), 0);
  self.take_changed_values(A, fixed);
  return self.factorise_changed(context);
}

bool SparseCholesky::refactorise_fixed(const SparseMatrix& A, std::span<const uint8_t> fixed,
                                       const RunContext& context) {
  Implementation& self = *implementation_;
  if (self.values.empty()) return factorise(A, fixed, context);
  assert(static_cast<Index>(fixed.size()) == A.rows());
  self.outdated.assign(self.outdated.size(), 0);
  self.take_fixed(A, fixed);
  return self.factorise_changed(context);
}

const SymmetricGraph& SparseCholesky::graph() const { return implementation_->graph; }

VectorXd SparseCholesky::solve(const VectorXd& b) const {
  const FactorMemory& factor = implementation_->memory;
  return solve_backward(factor, solve_forward(factor, b));
}

VectorXd SparseCholesky::solve(const VectorXd& b, ForwardSweep& last) const {
  const FactorMemory& factor = implementation_->memory;
  return solve_backward(factor, solve_forward(factor, b, implementation_->version, last));
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

#include "kernel/solvers/sparse_cholesky.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <array>
#include <cassert>
#include <new>
#include <vector>

#include "kernel/solvers/front_layout.h"
#include "kernel/solvers/frontal_kernels.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Doubles at the start of a cache line, where packs of rows are read fastest.
class AlignedArray {
 public:
  /// Makes room for `size` doubles, uninitialised; what was there before is lost.
  void make_room(Index size) {
    if (data_ != nullptr && size <= capacity_) return;
    data_.reset();
    data_.reset(static_cast<double*>(
        ::operator new(static_cast<size_t>(size) * sizeof(double), alignment)));
    capacity_ = size;
  }
  double* data() const { return data_.get(); }

 private:
  static constexpr std::align_val_t alignment{64};
  struct Free {
    void operator()(double* data) const { ::operator delete(data, alignment); }
  };
  std::unique_ptr<double, Free> data_;
  Index capacity_ = 0;
};

std::vector<int> fill_reducing_order(const SparseMatrix& A) {
  if (A.rows() == 0) return {};
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(A.selfadjointView<Eigen::Lower>(), permutation);
  return {permutation.indices().begin(), permutation.indices().end()};
}

/// Adds the update of `child` to its parent; rows[i] is the parent's row of the child's row i.
void add_update(const Front& child, const int* rows, const Front& parent) {
  for (int j = child.columns; j < child.rows; ++j) {
    const double* from = child.column(j);
    double* to = parent.column(rows[j]);
    for (int i = j; i < child.rows; ++i) to[rows[i]] += from[i];
  }
}

}  // namespace

struct SparseCholesky::Implementation {
  FrontLayout layout;
  AlignedArray panels;
  std::array<AlignedArray, 2> stacks;
  bool incremental = false;
  std::vector<double> values;
  std::vector<uint8_t> fixed;     ///< of the last factorisation, or empty: none
  std::vector<uint8_t> outdated;  ///< #S

  Front front(int s) const {
    const Supernodes& fronts = layout.fronts;
    return {fronts.rows(s), fronts.columns(s), panels.data() + layout.panel_begin[s],
            stacks[layout.stack[s]].data() + layout.update_begin[s]};
  }

  /// Sums the matrix's entries and the children's updates.
  void assemble(int s, const Front& target, const double* entries) const {
    std::fill(target.panel, target.panel + target.stride() * target.columns, 0.0);
    std::fill(target.update, target.update + target.update_size(), 0.0);
    for (Index e = layout.entry_begin[s]; e < layout.entry_begin[s + 1]; ++e)
      target.panel[layout.entries[e].target] = entries[layout.entries[e].source];
    for (int child = layout.first_child[s]; child >= 0; child = layout.next_sibling[child])
      add_update(front(child), layout.row_in_parent.data() + layout.fronts.row_begin[child],
                 target);
  }

  /// Computes the fronts that are out of date and those that depend on them.
  bool factorise_outdated(const SparseMatrix& A) {
    const double* entries = values_of(A);
    const FrontalKernels& kernels = best_kernels();
    for (int s = 0; s < layout.fronts.size(); ++s) {
      if (outdated[s] == 0) continue;
      if (layout.fronts.parent[s] >= 0) outdated[layout.fronts.parent[s]] = 1;
      const Front target = front(s);
      assemble(s, target, entries);
      if (!kernels.eliminate(target)) return false;
    }
    return true;
  }

  /// The values of A, with fixed rows and columns as those of the identity.
  const double* values_of(const SparseMatrix& A) {
    if (fixed.empty()) return A.valuePtr();
    values.resize(static_cast<size_t>(A.outerIndexPtr()[A.outerSize()]));
    for (int j = 0; j < A.outerSize(); ++j)
      for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry) {
        const bool identity = fixed[j] != 0 || fixed[entry.row()] != 0;
        values[&entry.value() - A.valuePtr()] = !identity          ? entry.value()
                                                : entry.row() == j ? 1
                                                                   : 0;
      }
    return values.data();
  }

  /// Marks the fronts that hold entries of rows or columns that begin or cease to be fixed.
  void mark_outdated(const SparseMatrix& A, std::span<const uint8_t> next) {
    const auto changes = [&](Index i) { return (fixed.empty() ? 0 : fixed[i]) != next[i]; };
    outdated.assign(layout.fronts.parent.size(), 0);
    for (int j = 0; j < A.outerSize(); ++j) {
      const bool column_changes = changes(j);
      for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
        if (entry.row() >= j && (column_changes || changes(entry.row())))
          outdated[std::min(layout.front_of[j], layout.front_of[entry.row()])] = 1;
    }
  }

  /// y := L^-1 y, in the order of elimination. x holds the rows of a front.
  void solve_forward(VectorXd& y, VectorXd& x) const {
    const FrontalKernels& kernels = best_kernels();
    for (int s = 0; s < layout.fronts.size(); ++s) {
      const Front source = front(s);
      const int* row = layout.fronts.row.data() + layout.fronts.row_begin[s];
      for (int i = 0; i < source.rows; ++i) x[i] = y[row[i]];
      kernels.solve_forward(source, x.data());
      for (int i = 0; i < source.rows; ++i) y[row[i]] = x[i];
    }
  }

  void solve_backward(VectorXd& y, VectorXd& x) const {
    const FrontalKernels& kernels = best_kernels();
    for (int s = layout.fronts.size() - 1; s >= 0; --s) {
      const Front source = front(s);
      const int* row = layout.fronts.row.data() + layout.fronts.row_begin[s];
      for (int i = 0; i < source.rows; ++i) x[i] = y[row[i]];
      kernels.solve_backward(source, x.data());
      for (int i = 0; i < source.columns; ++i) y[row[i]] = x[i];
    }
  }
};

SparseCholesky::SparseCholesky() : implementation_(std::make_unique<Implementation>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

void SparseCholesky::analyse(const SparseMatrix& A, Refactorisation refactorisation) {
  Implementation& self = *implementation_;
  self.incremental = refactorisation == Refactorisation::incremental;
  const SymmetricGraph graph = make_symmetric_graph(A);
  self.layout = lay_out(A, graph, make_supernodes(graph, fill_reducing_order(A)),
                        self.incremental ? Updates::kept : Updates::stacked);
  self.panels.make_room(self.layout.panel_begin.back());
  for (int i = 0; i < 2; ++i) self.stacks[i].make_room(self.layout.stack_size[i]);
}

Index SparseCholesky::factor_entries() const {
  const Supernodes& fronts = implementation_->layout.fronts;
  Index entries = 0;
  for (int s = 0; s < fronts.size(); ++s)
    for (int c = 0; c < fronts.columns(s); ++c) entries += fronts.rows(s) - c;
  return entries;
}

bool SparseCholesky::factorise(const SparseMatrix& A, std::span<const uint8_t> fixed) {
  Implementation& self = *implementation_;
  assert(A.rows() == static_cast<Index>(self.layout.fronts.order.size()));
  assert(fixed.empty() || static_cast<Index>(fixed.size()) == A.rows());
  self.fixed.assign(fixed.begin(), fixed.end());
  self.outdated.assign(self.layout.fronts.parent.size(), 1);
  return self.factorise_outdated(A);
}

bool SparseCholesky::refactorise(const SparseMatrix& A, std::span<const uint8_t> fixed) {
  assert(static_cast<Index>(fixed.size()) == A.rows());
  Implementation& self = *implementation_;
  if (!self.incremental) return factorise(A, fixed);
  self.mark_outdated(A, fixed);
  self.fixed.assign(fixed.begin(), fixed.end());
  return self.factorise_outdated(A);
}

VectorXd SparseCholesky::solve(const VectorXd& b) const {
  const Implementation& self = *implementation_;
  const std::vector<int>& order = self.layout.fronts.order;
  VectorXd y(b.size());
  for (Index i = 0; i < y.size(); ++i) y[i] = b[order[i]];
  VectorXd x = VectorXd::Zero(padded(self.layout.most_rows));
  self.solve_forward(y, x);
  self.solve_backward(y, x);
  VectorXd solution(b.size());
  for (Index i = 0; i < y.size(); ++i) solution[order[i]] = y[i];
  return solution;
}

VectorXd multiply_symmetric(const SparseMatrix& lower, const VectorXd& x) {
  return lower.selfadjointView<Eigen::Lower>() * x;
}

}  // namespace relievo

#include "kernel/solvers/sparse_cholesky.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <array>
#include <cassert>
#include <new>

#include "kernel/solvers/front_layout.h"
#include "kernel/solvers/frontal_kernels.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Uninitialised doubles at the start of a cache line, where packs of rows are read fastest.
class AlignedArray {
 public:
  explicit AlignedArray(Index size = 0)
      : data_(static_cast<double*>(
            ::operator new(static_cast<size_t>(size) * sizeof(double), alignment))) {}
  double* data() const { return data_.get(); }

 private:
  static constexpr std::align_val_t alignment{64};
  struct Free {
    void operator()(double* data) const { ::operator delete(data, alignment); }
  };
  std::unique_ptr<double, Free> data_;
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
  std::vector<double> values;

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

  bool factorise(const double* entries) const {
    const FrontalKernels& kernels = best_kernels();
    for (int s = 0; s < layout.fronts.size(); ++s) {
      const Front target = front(s);
      assemble(s, target, entries);
      if (!kernels.eliminate(target)) return false;
    }
    return true;
  }

  void fix(const SparseMatrix& A, std::span<const uint8_t> fixed) {
    values.resize(static_cast<size_t>(A.outerIndexPtr()[A.outerSize()]));
    for (int j = 0; j < A.outerSize(); ++j)
      for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry) {
        const bool identity = fixed[j] != 0 || fixed[entry.row()] != 0;
        values[&entry.value() - A.valuePtr()] = !identity          ? entry.value()
                                                : entry.row() == j ? 1
                                                                   : 0;
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

void SparseCholesky::analyse(const SparseMatrix& A) { analyse(A, fill_reducing_order(A)); }

void SparseCholesky::analyse(const SparseMatrix& A, const std::vector<int>& order) {
  assert(static_cast<Index>(order.size()) == A.rows());
  Implementation& self = *implementation_;
  self.layout = lay_out(A, make_supernodes(A, order));
  self.panels = AlignedArray(self.layout.panel_begin.back());
  for (int i = 0; i < 2; ++i) self.stacks[i] = AlignedArray(self.layout.stack_size[i]);
}

const std::vector<int>& SparseCholesky::order() const {
  return implementation_->layout.fronts.order;
}

Index SparseCholesky::factor_entries() const {
  const Supernodes& fronts = implementation_->layout.fronts;
  Index entries = 0;
  for (int s = 0; s < fronts.size(); ++s)
    for (int c = 0; c < fronts.columns(s); ++c) entries += fronts.rows(s) - c;
  return entries;
}

bool SparseCholesky::factorise(const SparseMatrix& A, std::span<const uint8_t> fixed) {
  assert(A.rows() == static_cast<Index>(order().size()));
  assert(fixed.empty() || static_cast<Index>(fixed.size()) == A.rows());
  if (fixed.empty()) return implementation_->factorise(A.valuePtr());
  implementation_->fix(A, fixed);
  return implementation_->factorise(implementation_->values.data());
}

VectorXd SparseCholesky::solve(const VectorXd& b) const {
  const Implementation& self = *implementation_;
  VectorXd y(b.size());
  for (Index i = 0; i < y.size(); ++i) y[i] = b[order()[i]];
  VectorXd x = VectorXd::Zero(padded(self.layout.most_rows));
  self.solve_forward(y, x);
  self.solve_backward(y, x);
  VectorXd solution(b.size());
  for (Index i = 0; i < y.size(); ++i) solution[order()[i]] = y[i];
  return solution;
}

VectorXd multiply_symmetric(const SparseMatrix& lower, const VectorXd& x) {
  return lower.selfadjointView<Eigen::Lower>() * x;
}

}  // namespace relievo

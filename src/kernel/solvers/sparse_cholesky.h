#pragma once

#include <Eigen/Core>
#include <memory>

#include "kernel/base/sparse_matrix.h"

namespace relievo {

/// Cholesky factorisation of symmetric positive definite sparse matrices: the pattern is analysed
/// once, values are factorised as often as needed. Only the lower triangle (row >= column) of the
/// matrices is read; explicit zeros belong to the pattern.
class SparseCholesky {
 public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Chooses a fill-reducing order for the pattern of A. Near-linear in its entries.
  void analyse(const SparseMatrix& A);

  /// Factorises values on the analysed pattern; false when A is not positive definite.
  bool factorise(const SparseMatrix& A);

  /// Solves A x = b with the last factorised A, b having #rows entries.
  /// Precondition: the last factorise() returned true.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// y = A x for a symmetric A of which only the lower triangle is stored. O(entries).
Eigen::VectorXd multiply_symmetric(const SparseMatrix& lower, const Eigen::VectorXd& x);

}  // namespace relievo

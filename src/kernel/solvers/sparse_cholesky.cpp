#include "kernel/solvers/sparse_cholesky.h"

#include <Eigen/SparseCholesky>

namespace relievo {

struct SparseCholesky::Implementation {
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt;
};

SparseCholesky::SparseCholesky() : implementation_(std::make_unique<Implementation>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

void SparseCholesky::analyse(const SparseMatrix& A) { implementation_->ldlt.analyzePattern(A); }

bool SparseCholesky::factorise(const SparseMatrix& A) {
  implementation_->ldlt.factorize(A);
  if (implementation_->ldlt.info() != Eigen::Success) return false;
  return A.rows() == 0 || implementation_->ldlt.vectorD().minCoeff() > 0;
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& b) const {
  if (b.size() == 0) return b;
  return implementation_->ldlt.solve(b);
}

Eigen::VectorXd multiply_symmetric(const SparseMatrix& lower, const Eigen::VectorXd& x) {
  return lower.selfadjointView<Eigen::Lower>() * x;
}

}  // namespace relievo

#include "kernel/solvers/sparse_cholesky.h"

#include <gtest/gtest.h>

#include "kernel/operators/laplacian.h"
#include "support/structured_meshes.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

SparseMatrix shifted_laplacian(double shift) {
  const testing::PlanarMesh mesh = testing::jittered(testing::disc_mesh(1, 12), 0.02);
  SparseMatrix A = stiffness_matrix(mesh.flat());
  A.diagonal() += VectorXd::Constant(A.rows(), shift);
  return A;
}

SparseMatrix lower_of(const SparseMatrix& A) { return A.triangularView<Eigen::Lower>(); }

TEST(SparseCholesky, SolvesManyValuesOnOnePattern) {
  SparseCholesky factor;
  factor.analyse(lower_of(shifted_laplacian(1)));
  for (const double shift : {1.0, 0.01, 100.0}) {
    const SparseMatrix A = shifted_laplacian(shift);
    const VectorXd x = VectorXd::LinSpaced(A.rows(), -1, 2);
    ASSERT_TRUE(factor.factorise(lower_of(A)));
    EXPECT_LE((factor.solve(A * x) - x).lpNorm<Eigen::Infinity>(), 1e-10);
  }
}

TEST(SparseCholesky, ReadsTheLowerTriangleOnly) {
  SparseMatrix A = shifted_laplacian(1);
  const VectorXd x = VectorXd::Ones(A.rows());
  const VectorXd b = A * x;
  for (int j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
      if (entry.row() < j) entry.valueRef() = 1e9;
  SparseCholesky factor;
  factor.analyse(A);
  ASSERT_TRUE(factor.factorise(A));
  EXPECT_LE((factor.solve(b) - x).lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(SparseCholesky, KeepsExplicitZerosInThePattern) {
  SparseMatrix A = lower_of(shifted_laplacian(1));
  SparseMatrix decoupled = A;
  for (int j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(decoupled, j); entry; ++entry)
      entry.valueRef() = entry.row() == j ? 2 : 0;
  SparseCholesky factor;
  factor.analyse(decoupled);
  ASSERT_TRUE(factor.factorise(decoupled));
  const VectorXd x = VectorXd::LinSpaced(A.rows(), 0, 1);
  EXPECT_EQ(factor.solve(2 * x), x);
  ASSERT_TRUE(factor.factorise(A));
  EXPECT_LE((factor.solve(multiply_symmetric(A, x)) - x).lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(SparseCholesky, RefusesWhatIsNotPositiveDefinite) {
  SparseCholesky factor;
  factor.analyse(lower_of(shifted_laplacian(0)));
  EXPECT_FALSE(factor.factorise(lower_of(shifted_laplacian(-0.1))));
  EXPECT_TRUE(factor.factorise(lower_of(shifted_laplacian(0.1))));
}

TEST(SparseCholesky, SolvesTheEmptySystem) {
  SparseCholesky factor;
  const SparseMatrix empty(0, 0);
  factor.analyse(empty);
  ASSERT_TRUE(factor.factorise(empty));
  EXPECT_EQ(factor.solve(VectorXd()).size(), 0);
}

}  // namespace
}  // namespace relievo

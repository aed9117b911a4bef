#include "kernel/cholesky/sparse_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <atomic>
#include <limits>

#include "kernel/base/workers.h"
#include "kernel/cholesky/sparse_products.h"
#include "kernel/operators/laplacian.h"
#include "support/sparse_patterns.h"
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
      entry.valueRef() = entry.row() == j ? 4 : 0;
  SparseCholesky factor;
  factor.analyse(decoupled);
  ASSERT_TRUE(factor.factorise(decoupled));
  const VectorXd x = VectorXd::LinSpaced(A.rows(), 0, 1);
  EXPECT_EQ(factor.solve(4 * x), x);
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

TEST(SparseCholesky, SolvesLikeDenseCholesky) {
  for (const auto& [name, lower] : testing::telling_matrices()) {
    SparseCholesky factor;
    factor.analyse(lower);
    ASSERT_TRUE(factor.factorise(lower)) << name;
    const VectorXd b = VectorXd::LinSpaced(lower.rows(), -1, 3);
    const VectorXd expected = testing::dense_symmetric(lower).llt().solve(b);
    EXPECT_LE((factor.solve(b) - expected).lpNorm<Eigen::Infinity>(),
              1e-12 * std::max(1.0, expected.lpNorm<Eigen::Infinity>()))
        << name;
  }
}

TEST(SparseCholesky, SolvesALargeGridLikeASparseReference) {
  const SparseMatrix lower = testing::grid_laplacian(100, 100, 1e-3);
  SparseCholesky factor;
  factor.analyse(lower);
  ASSERT_TRUE(factor.factorise(lower));
  const VectorXd b = VectorXd::LinSpaced(lower.rows(), -1, 3);
  const VectorXd x = factor.solve(b);
  const VectorXd expected = Eigen::SimplicialLLT<SparseMatrix>(lower).solve(b);
  EXPECT_LE((x - expected).lpNorm<Eigen::Infinity>(), 1e-11 * expected.lpNorm<Eigen::Infinity>());
  EXPECT_LE((multiply_symmetric(lower, x) - b).lpNorm<Eigen::Infinity>(),
            1e-13 * 8 * x.lpNorm<Eigen::Infinity>());
}

TEST(SparseCholesky, StoresLittleMoreThanTheSimplicialFactor) {
  for (const int side : {30, 100, 200}) {
    const SparseMatrix lower = testing::grid_laplacian(side, side, 1);
    SparseCholesky factor;
    factor.analyse(lower);
    Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>> reference(lower);
    const SparseMatrix L = reference.matrixL();
    EXPECT_GE(factor.factor_entries(), L.nonZeros());
    EXPECT_LE(static_cast<double>(factor.factor_entries()),
              1.35 * static_cast<double>(L.nonZeros()));
  }
}

TEST(SparseCholesky, FixedRowsActAsThoseOfTheIdentity) {
  const SparseMatrix lower = testing::grid_laplacian(13, 9, 0.1);
  std::vector<uint8_t> fixed(static_cast<size_t>(lower.rows()));
  for (size_t i = 0; i < fixed.size(); ++i) fixed[i] = i % 3 == 0 || i % 7 == 0;
  SparseMatrix replaced = lower;
  for (int j = 0; j < lower.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(replaced, j); entry; ++entry)
      if (fixed[j] != 0 || fixed[entry.row()] != 0) entry.valueRef() = entry.row() == j ? 1 : 0;
  SparseCholesky one;
  SparseCholesky other;
  one.analyse(lower);
  other.analyse(lower);
  ASSERT_TRUE(one.factorise(lower, fixed));
  ASSERT_TRUE(other.factorise(replaced));
  const VectorXd b = VectorXd::LinSpaced(lower.rows(), -1, 3);
  const VectorXd x = one.solve(b);
  EXPECT_EQ(x, other.solve(b));
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (fixed[i] != 0) {
      EXPECT_EQ(x[i], b[i]);
    }
}

TEST(SparseCholesky, RefactorisesWithTheSameBits) {
  for (const Refactorisation kind : {Refactorisation::complete, Refactorisation::incremental})
    for (const auto& [name, lower] : testing::telling_matrices()) {
      const VectorXd b = VectorXd::LinSpaced(lower.rows(), -1, 3);
      SparseCholesky changing;
      changing.analyse(lower, kind);
      ASSERT_TRUE(changing.factorise(lower)) << name;
      for (const size_t step : {2, 3, 3, 50, 1000, 1}) {
        std::vector<uint8_t> fixed(static_cast<size_t>(lower.rows()), 0);
        for (size_t i = step / 2; i < fixed.size(); i += step) fixed[i] = 1;
        SparseCholesky fresh;
        fresh.analyse(lower);
        ASSERT_TRUE(fresh.factorise(lower, fixed)) << name;
        ASSERT_TRUE(changing.refactorise(lower, fixed)) << name;
        EXPECT_EQ(changing.solve(b), fresh.solve(b)) << name << " " << step;
      }
    }
}

/// A local right-hand side does not reach whole subtrees, which the solve skips.
TEST(SparseCholesky, SolvesForALocalRightHandSideAsForAnyOther) {
  for (const auto& [name, lower] : testing::telling_matrices()) {
    SparseCholesky factor;
    factor.analyse(lower);
    ASSERT_TRUE(factor.factorise(lower)) << name;
    const VectorXd b = VectorXd::LinSpaced(lower.rows(), -1, 3);
    for (const Eigen::Index i : {Eigen::Index{0}, lower.rows() / 3, lower.rows() - 1}) {
      VectorXd local = VectorXd::Zero(lower.rows());
      local[i] = 1;
      const VectorXd x = factor.solve(local);
      EXPECT_NEAR(b.dot(x), factor.solve(b)[i], 1e-10 * (1 + x.cwiseAbs().sum())) << name;
      EXPECT_LE((multiply_symmetric(lower, x) - local).cwiseAbs().maxCoeff(), 1e-10) << name;
    }
  }
}

TEST(SparseCholesky, RefactorisesChangedValuesWithTheSameBits) {
  for (const auto& [name, lower] : testing::telling_matrices()) {
    const VectorXd b = VectorXd::LinSpaced(lower.rows(), -1, 3);
    SparseMatrix A = lower;
    SparseCholesky changing;
    changing.analyse(A, Refactorisation::incremental);
    ASSERT_TRUE(changing.factorise(A)) << name;
    for (const Eigen::Index step : {1, 7, 100}) {
      for (Eigen::Index i = 0; i < A.rows(); i += step) A.coeffRef(i, i) *= 1.5;
      SparseCholesky fresh;
      fresh.analyse(A);
      ASSERT_TRUE(fresh.factorise(A)) << name;
      ASSERT_TRUE(changing.refactorise(A)) << name;
      EXPECT_EQ(changing.solve(b), fresh.solve(b)) << name << " " << step;
    }
  }
}

TEST(SparseCholesky, StartsAfreshAfterAFailure) {
  SparseMatrix A = testing::grid_laplacian(30, 20, 0.01);
  const VectorXd b = VectorXd::LinSpaced(A.rows(), -1, 3);
  SparseCholesky factor;
  factor.analyse(A, Refactorisation::incremental);
  ASSERT_TRUE(factor.factorise(A));
  const VectorXd x = factor.solve(b);
  SparseMatrix bad = A;
  bad.coeffRef(100, 100) = -1;
  EXPECT_FALSE(factor.refactorise(bad));
  ASSERT_TRUE(factor.refactorise(A));
  EXPECT_EQ(factor.solve(b), x);
}

TEST(SparseCholesky, LeavesTheSchurComplementOnTheLastRows) {
  const SparseMatrix A = shifted_laplacian(0.5);
  const auto n = static_cast<int>(A.rows());
  std::vector<int> rows;
  for (int i = n - 1; i >= 0; i -= 7) rows.push_back(i);
  std::vector<int> order;
  for (int i = 0; i < n; ++i)
    if (std::count(rows.begin(), rows.end(), i) == 0) order.push_back(i);
  order.insert(order.end(), rows.begin(), rows.end());
  SparseCholesky factor;
  factor.analyse(lower_of(A), Refactorisation::complete, order);
  ASSERT_TRUE(factor.factorise(lower_of(A)));
  const Eigen::MatrixXd S = factor.schur_complement(rows);
  const Eigen::MatrixXd inverse = Eigen::MatrixXd(A).inverse();
  Eigen::MatrixXd block(rows.size(), rows.size());
  for (size_t i = 0; i < rows.size(); ++i)
    for (size_t j = 0; j < rows.size(); ++j)
      block(static_cast<int>(i), static_cast<int>(j)) = inverse(rows[i], rows[j]);
  EXPECT_LE((S * block - Eigen::MatrixXd::Identity(S.rows(), S.cols())).norm(), 1e-10);
  EXPECT_EQ(S, S.transpose());
}

TEST(SparseCholesky, StopsWhenCancelled) {
  const SparseMatrix A = testing::grid_laplacian(30, 20, 0.01);
  SparseCholesky factor;
  factor.analyse(A);
  const std::atomic<bool> cancel = true;
  EXPECT_FALSE(factor.factorise(A, {}, RunContext{&cancel}));
  EXPECT_TRUE(factor.factorise(A));
  EXPECT_FALSE(factor.analyse(A, Refactorisation::complete, {}, RunContext{&cancel}));
  ASSERT_TRUE(factor.analyse(A));
  EXPECT_TRUE(factor.factorise(A));
}

TEST(SparseCholesky, GivesTheSameBitsWithAnyNumberOfThreads) {
  const SparseMatrix lower = testing::grid_laplacian(150, 120, 0.01);
  const VectorXd b = VectorXd::LinSpaced(lower.rows(), -1, 3);
  VectorXd expected;
  for (const Refactorisation kind : {Refactorisation::complete, Refactorisation::incremental})
    for (const int workers : {1, 2, 5}) {
      set_worker_count(workers);
      SparseCholesky factor;
      factor.analyse(lower, kind);
      ASSERT_TRUE(factor.factorise(lower));
      const VectorXd x = factor.solve(b);
      if (expected.size() == 0) expected = x;
      EXPECT_EQ(x, expected) << workers;
    }
  set_worker_count(0);
}

TEST(SparseCholesky, GivesTheSameBitsEveryTime) {
  const SparseMatrix lower = testing::grid_laplacian(60, 40, 0.01);
  const VectorXd b = VectorXd::LinSpaced(lower.rows(), -1, 3);
  SparseCholesky first;
  first.analyse(lower);
  ASSERT_TRUE(first.factorise(lower));
  const VectorXd x = first.solve(b);
  for (int repeat = 0; repeat < 3; ++repeat) {
    ASSERT_TRUE(first.factorise(SparseMatrix(2 * lower)));
    ASSERT_TRUE(first.factorise(lower));
    EXPECT_EQ(first.solve(b), x);
    SparseCholesky again;
    again.analyse(lower);
    ASSERT_TRUE(again.factorise(lower));
    EXPECT_EQ(again.solve(b), x);
  }
}

TEST(SparseCholesky, RefusesOneBadPivotAnywhere) {
  for (const auto& [name, lower] : testing::telling_matrices()) {
    SparseCholesky factor;
    factor.analyse(lower);
    for (const double bad : {-1e3, std::numeric_limits<double>::quiet_NaN()})
      for (const Eigen::Index i : {Eigen::Index{0}, lower.rows() / 2, lower.rows() - 1}) {
        SparseMatrix A = lower;
        A.coeffRef(i, i) = bad;
        EXPECT_FALSE(factor.factorise(A)) << name;
      }
    EXPECT_TRUE(factor.factorise(lower)) << name;
  }
}

}  // namespace
}  // namespace relievo

#include "kernel/cholesky/frontal_kernels.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <atomic>
#include <cmath>
#include <vector>

#include "kernel/base/workers.h"
#include "kernel/cholesky/eliminate_front.h"

namespace relievo {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A front with its memory, filled from the lower triangle of a matrix.
class OwnedFront {
 public:
  OwnedFront(const MatrixXd& A, int columns) {
    front_.rows = static_cast<int>(A.rows());
    front_.columns = columns;
    panel_.assign(static_cast<size_t>(front_.stride() * columns), 0);
    update_.assign(front_.update_size(), 0);
    front_.panel = panel_.data();
    front_.update = update_.data();
    for (int c = 0; c < front_.rows; ++c)
      for (int r = c; r < front_.rows; ++r) front_.column(c)[r] = A(r, c);
  }

  const Front& get() const { return front_; }

  MatrixXd lower() const {
    MatrixXd L = MatrixXd::Zero(front_.rows, front_.rows);
    for (int c = 0; c < front_.rows; ++c)
      for (int r = c; r < front_.rows; ++r) L(r, c) = front_.column(c)[r];
    return L;
  }

 private:
  Front front_;
  std::vector<double> panel_;
  std::vector<double> update_;
};

MatrixXd positive_definite(int n) {
  MatrixXd F(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) F(i, j) = ((i * 37 + j * 17 + i * j * 5) % 101) / 50.0 - 1;
  return F * F.transpose() / n + MatrixXd::Identity(n, n);
}

const std::vector<std::pair<int, int>> shapes = {
    {1, 1},  {2, 1},  {3, 3},   {4, 2},   {5, 5},   {7, 3},     {8, 4},    {9, 6},    {13, 1},
    {16, 8}, {31, 7}, {64, 64}, {67, 65}, {90, 70}, {150, 130}, {201, 66}, {301, 230}};

TEST(FrontalKernels, EliminateLikeDenseCholesky) {
  for (const FrontalKernels* kernels : {&portable_kernels(), &best_kernels()})
    for (const auto& [n, k] : shapes) {
      const MatrixXd A = positive_definite(n);
      const OwnedFront front(A, k);
      ASSERT_TRUE(eliminate_front(*kernels, front.get(), nullptr)) << n << " " << k;
      const MatrixXd L = A.llt().matrixL();
      MatrixXd rest = L;
      rest.leftCols(k).setZero();
      MatrixXd expected = MatrixXd(rest * rest.transpose()).triangularView<Eigen::Lower>();
      expected.leftCols(k) = L.leftCols(k);
      EXPECT_LE((front.lower() - expected).cwiseAbs().maxCoeff(), 1e-13) << n << " " << k;
    }
}

TEST(FrontalKernels, SolveWithTheColumnsOfTheFactor) {
  for (const FrontalKernels* kernels : {&portable_kernels(), &best_kernels()})
    for (const auto& [n, k] : shapes) {
      const OwnedFront front(positive_definite(n), k);
      ASSERT_TRUE(eliminate_front(*kernels, front.get(), nullptr));
      MatrixXd L = front.lower();
      L.rightCols(n - k).setZero();
      L.bottomRightCorner(n - k, n - k).setIdentity();
      const VectorXd b = VectorXd::LinSpaced(n, -1, 2);
      VectorXd x = VectorXd::Zero(padded(n));
      x.head(n) = b;
      kernels->solve_forward(front.get(), x.data());
      EXPECT_LE((L * x.head(n) - b).cwiseAbs().maxCoeff(), 1e-13) << n << " " << k;
      x.head(n) = b;
      kernels->solve_backward(front.get(), x.data());
      EXPECT_LE((L.transpose() * x.head(n) - b).head(k).cwiseAbs().maxCoeff(), 1e-12);
      EXPECT_EQ(x.segment(k, n - k), b.tail(n - k));
    }
}

TEST(FrontalKernels, GiveTheSameBitsOnEveryProcessor) {
  for (const auto& [n, k] : shapes) {
    const OwnedFront one(positive_definite(n), k);
    const OwnedFront other(positive_definite(n), k);
    ASSERT_TRUE(eliminate_front(portable_kernels(), one.get(), nullptr));
    ASSERT_TRUE(eliminate_front(best_kernels(), other.get(), nullptr));
    EXPECT_EQ(one.lower(), other.lower()) << n << " " << k;
    VectorXd x = VectorXd::Zero(padded(n));
    x.head(n).setLinSpaced(-3, 1);
    VectorXd y = x;
    portable_kernels().solve_forward(one.get(), x.data());
    portable_kernels().solve_backward(one.get(), x.data());
    best_kernels().solve_forward(other.get(), y.data());
    best_kernels().solve_backward(other.get(), y.data());
    EXPECT_EQ(x, y) << n << " " << k;
  }
}

TEST(FrontalKernels, GiveTheSameBitsWithAnyNumberOfThreads) {
  for (const auto& [n, k] : shapes) {
    const OwnedFront one(positive_definite(n), k);
    const OwnedFront other(positive_definite(n), k);
    set_worker_count(1);
    ASSERT_TRUE(eliminate_front(best_kernels(), one.get(), nullptr));
    set_worker_count(3);
    ASSERT_TRUE(eliminate_front(best_kernels(), other.get(), nullptr));
    set_worker_count(0);
    EXPECT_EQ(one.lower(), other.lower()) << n << " " << k;
  }
}

TEST(FrontalKernels, RefuseAPivotThatIsNotPositive) {
  for (const FrontalKernels* kernels : {&portable_kernels(), &best_kernels()})
    for (const double pivot : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
      MatrixXd A = positive_definite(9);
      A(6, 6) = pivot;
      EXPECT_FALSE(eliminate_front(*kernels, OwnedFront(A, 7).get(), nullptr)) << pivot;
      EXPECT_TRUE(eliminate_front(*kernels, OwnedFront(A, 6).get(), nullptr)) << pivot;
    }
}

TEST(FrontalKernels, StopWhereTheyAreTold) {
  const MatrixXd A = positive_definite(200);
  for (const FrontalKernels* kernels : {&portable_kernels(), &best_kernels()})
    for (const bool told : {false, true}) {
      const std::atomic<bool> stop = told;
      EXPECT_EQ(eliminate_front(*kernels, OwnedFront(A, 150).get(), &stop), !told);
    }
}

}  // namespace
}  // namespace relievo

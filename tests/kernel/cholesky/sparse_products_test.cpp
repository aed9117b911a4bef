#include "kernel/cholesky/sparse_products.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/base/workers.h"
#include "kernel/operators/laplacian.h"
#include "support/structured_meshes.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// Makes a matrix with enough entries for several threads and without any symmetry in its values.
SparseMatrix stiffness(int cells) {
  return stiffness_matrix(testing::jittered(testing::grid_mesh(cells, cells, 1), 0.02).flat());
}

VectorXd uneven(Eigen::Index size) {
  return VectorXd::NullaryExpr(
      size, [](Eigen::Index i) { return std::sin(7.0 * static_cast<double>(i * i)); });
}

TEST(SparseProducts, AreThoseOfEigen) {
  for (const int cells : {3, 40, 160}) {
    const SparseMatrix A = stiffness(cells);
    const SparseMatrix lower = A.triangularView<Eigen::Lower>();
    const VectorXd x = uneven(A.cols());
    EXPECT_LE((multiply_symmetric(lower, x) - A * x).lpNorm<Eigen::Infinity>(), 1e-13);
    EXPECT_LE((multiply_transposed(A, x) - A * x).lpNorm<Eigen::Infinity>(), 1e-13);
    const VectorXd transposed = lower.transpose() * x;
    EXPECT_LE((multiply_transposed(lower, x) - transposed).lpNorm<Eigen::Infinity>(), 1e-13);
  }
}

TEST(SparseProducts, HaveTheSameBitsWithAnyNumberOfThreads) {
  const SparseMatrix A = stiffness(160);
  const SparseMatrix lower = A.triangularView<Eigen::Lower>();
  const VectorXd x = uneven(A.cols());
  set_worker_count(1);
  const VectorXd symmetric = multiply_symmetric(lower, x);
  const VectorXd transposed = multiply_transposed(A, x);
  set_worker_count(3);
  EXPECT_EQ(multiply_symmetric(lower, x), symmetric);
  EXPECT_EQ(multiply_transposed(A, x), transposed);
  set_worker_count(0);
}

}  // namespace
}  // namespace relievo

#include "kernel/operators/dissection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/operators/laplacian.h"
#include "support/structured_meshes.h"

namespace relievo {
namespace {

using testing::PlanarMesh;

std::vector<int> order_of(const PlanarMesh& mesh) {
  return dissection_order(mesh.flat(), std::vector<int>(mesh.vertices.size(), 1));
}

SparseMatrix definite_laplacian(const PlanarMesh& mesh) {
  SparseMatrix A = stiffness_matrix(mesh.flat());
  A.diagonal().array() += 1;
  return A;
}

TEST(Dissection, OrdersEveryVertexOnce) {
  for (const int rings : {1, 2, 5, 30}) {
    std::vector<int> order = order_of(testing::disc_mesh(1, rings));
    std::vector<int> all(order.size());
    std::iota(all.begin(), all.end(), 0);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, all);
  }
  EXPECT_TRUE(dissection_order({}, {}).empty());
}

TEST(Dissection, CopesWithPointsAtOnePlace) {
  const std::vector<Point2> points(100, Point2{3, 4});
  EXPECT_EQ(dissection_order({points, {}}, std::vector<int>(100, 1)).size(), 100u);
}

TEST(Dissection, FillsInHardlyMoreThanMinimumDegree) {
  for (const int rings : {20, 60, 120}) {
    const PlanarMesh mesh = testing::jittered(testing::disc_mesh(1, rings), 0.2 / rings);
    const SparseMatrix A = definite_laplacian(mesh);
    SparseCholesky minimum_degree;
    SparseCholesky dissection;
    minimum_degree.analyse(A);
    dissection.analyse(A, Refactorisation::complete, order_of(mesh));
    EXPECT_LE(static_cast<double>(dissection.factor_entries()),
              1.3 * static_cast<double>(minimum_degree.factor_entries()))
        << rings;
  }
}

TEST(Dissection, SolvesTheSameSystem) {
  const PlanarMesh mesh = testing::disc_mesh(1, 40);
  const SparseMatrix A = definite_laplacian(mesh);
  SparseCholesky factor;
  factor.analyse(A, Refactorisation::incremental, order_of(mesh));
  ASSERT_TRUE(factor.factorise(A));
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(A.rows(), -1, 2);
  EXPECT_LE((factor.solve(A * x) - x).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST(Dissection, DoesNotDependOnTheUnitOfLength) {
  PlanarMesh mesh = testing::jittered(testing::disc_mesh(1, 25), 0.01);
  const std::vector<int> order = order_of(mesh);
  for (Point2& p : mesh.vertices) p = 1024 * p;
  EXPECT_EQ(order_of(mesh), order);
}

}  // namespace
}  // namespace relievo

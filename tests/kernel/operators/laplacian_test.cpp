#include "kernel/operators/laplacian.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numeric>

#include "kernel/operators/gradient.h"
#include "support/structured_meshes.h"

namespace relievo {
namespace {

using Eigen::VectorXd;
using testing::PlanarMesh;

PlanarMesh irregular_mesh() { return testing::jittered(testing::grid_mesh(9, 7, 0.5), 0.15); }

VectorXd sampled(const PlanarMesh& mesh, double a, double b, double c) {
  VectorXd values(static_cast<Eigen::Index>(mesh.vertices.size()));
  for (Eigen::Index v = 0; v < values.size(); ++v)
    values[v] = a + b * mesh.vertices[v].x + c * mesh.vertices[v].y;
  return values;
}

TEST(Stiffness, ConstantsAreInTheKernel) {
  const PlanarMesh mesh = irregular_mesh();
  const VectorXd force = stiffness_matrix(mesh.flat()) * sampled(mesh, 3, 0, 0);
  EXPECT_LE(force.lpNorm<Eigen::Infinity>(), 1e-13);
}

TEST(Stiffness, LinearFunctionsAreHarmonicInside) {
  const PlanarMesh mesh = irregular_mesh();
  const VectorXd force = stiffness_matrix(mesh.flat()) * sampled(mesh, 1, -2, 0.7);
  const std::vector<bool> boundary = boundary_vertices(mesh);
  for (Eigen::Index v = 0; v < force.size(); ++v)
    if (!boundary[v]) {
      EXPECT_NEAR(force[v], 0, 1e-13);
    }
}

TEST(Stiffness, EnergyOfLinearFunctionsIsTheirDirichletIntegral) {
  const PlanarMesh mesh = irregular_mesh();
  const VectorXd x = sampled(mesh, 1, -2, 0.5);
  const double area = 9 * 7 * 0.25;
  EXPECT_NEAR(x.dot(stiffness_matrix(mesh.flat()) * x), (4 + 0.25) * area, 1e-11);
}

TEST(Stiffness, IsSymmetricAndPositiveSemiDefiniteWithOneConstantPerSurface) {
  PlanarMesh mesh = irregular_mesh();
  const int first = static_cast<int>(mesh.vertices.size());
  const PlanarMesh other = testing::disc_mesh(1, 3);
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles)
    mesh.triangles.push_back({a + first, b + first, c + first});
  const Eigen::MatrixXd L = stiffness_matrix(mesh.flat());
  EXPECT_EQ(L, L.transpose());
  const VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(L).eigenvalues();
  EXPECT_NEAR(eigenvalues[0], 0, 1e-13);
  EXPECT_NEAR(eigenvalues[1], 0, 1e-13);
  EXPECT_GT(eigenvalues[2], 1e-3);
}

TEST(Stiffness, DoesNotDependOnTheUnitOfLength) {
  PlanarMesh mesh = irregular_mesh();
  const Eigen::MatrixXd L = stiffness_matrix(mesh.flat());
  for (Point2& p : mesh.vertices) p = 37.5 * p;
  EXPECT_LE((L - Eigen::MatrixXd(stiffness_matrix(mesh.flat()))).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Mass, AddsUpToTheArea) {
  const PlanarMesh mesh = irregular_mesh();
  const VectorXd mass = lumped_mass(mesh.flat());
  EXPECT_NEAR(mass.sum(), 9 * 7 * 0.25, 1e-12);
  EXPECT_GT(mass.minCoeff(), 0);
}

TEST(Load, IntegratesADensityPerTriangle) {
  const PlanarMesh mesh = irregular_mesh();
  std::vector<double> density(mesh.triangles.size());
  std::iota(density.begin(), density.end(), -5.0);
  const std::vector<double> areas = triangle_areas(mesh.flat());
  const double integral = std::inner_product(density.begin(), density.end(), areas.begin(), 0.0);
  EXPECT_NEAR(load_vector(mesh.flat(), density).sum(), integral, 1e-10);
}

TEST(Divergence, OfAGradientIsTheLaplacian) {
  const PlanarMesh mesh = irregular_mesh();
  VectorXd values = sampled(mesh, 1, -2, 0.7);
  for (Eigen::Index v = 0; v < values.size(); ++v) values[v] *= values[v];
  const std::vector<Point2> slopes =
      face_gradients(mesh.flat(), {values.data(), mesh.vertices.size()});
  const VectorXd force = stiffness_matrix(mesh.flat()) * values;
  EXPECT_LE((divergence_load(mesh.flat(), slopes) - force).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST(Divergence, OfAnyFieldAddsUpToNothing) {
  const PlanarMesh mesh = irregular_mesh();
  std::vector<Point2> field;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    field.push_back({std::sin(t), std::cos(3 * t)});
  const VectorXd load = divergence_load(mesh.flat(), field);
  EXPECT_NEAR(load.sum(), 0, 1e-12);
  EXPECT_GT(load.lpNorm<Eigen::Infinity>(), 0.1);
}

TEST(Galerkin, EqualsTheDenseProduct) {
  const PlanarMesh mesh = irregular_mesh();
  const SparseMatrix A = stiffness_matrix(mesh.flat());
  const int n = static_cast<int>(A.rows());
  SparseMatrix T(n, n - 10);
  for (int i = 0; i < n; ++i) {
    T.insert(i, i % (n - 10)) = 1;
    if (i % 3 == 0 && (i + 1) % (n - 10) != i % (n - 10)) T.insert(i, (i + 1) % (n - 10)) = -1;
  }
  const Eigen::MatrixXd dense = Eigen::MatrixXd(T).transpose() * Eigen::MatrixXd(A) * T;
  const Eigen::MatrixXd expected = dense.triangularView<Eigen::Lower>();
  EXPECT_LE((Eigen::MatrixXd(galerkin_lower(A, T)) - expected).cwiseAbs().maxCoeff(), 1e-13);
}

}  // namespace
}  // namespace relievo

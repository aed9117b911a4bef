#include "relief/cues/harmonic.h"

#include "kernel/operators/laplacian.h"
#include "kernel/solvers/sparse_cholesky.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Solves L x = load where not fixed, x = value where fixed.
MatrixXd solve_fixed(const SparseMatrix& L, const std::vector<uint8_t>& fixed, const MatrixXd& load,
                     const MatrixXd& values) {
  SparseCholesky factor;
  factor.analyse(L);
  MatrixXd x = MatrixXd::Zero(values.rows(), values.cols());
  if (!factor.factorise(L, fixed)) return x;
  for (Index v = 0; v < x.rows(); ++v)
    if (fixed[v] != 0) x.row(v) = values.row(v);
  const MatrixXd right = load - L * x;
  for (Index k = 0; k < x.cols(); ++k) {
    VectorXd b = right.col(k);
    for (Index v = 0; v < b.size(); ++v)
      if (fixed[v] != 0) b[v] = x(v, k);
    x.col(k) = factor.solve(b);
  }
  return x;
}

}  // namespace

MatrixXd harmonic_extension(const FlatMesh& mesh, std::vector<uint8_t> fixed, MatrixXd values,
                            double otherwise) {
  const std::vector<int> piece = connected_pieces(mesh.triangles, mesh.positions.size());
  std::vector<uint8_t> held(fixed.size(), 0);
  for (size_t v = 0; v < fixed.size(); ++v)
    if (fixed[v] != 0) held[piece[v]] = 1;
  for (size_t v = 0; v < fixed.size(); ++v) {
    if (held[piece[v]] != 0) continue;
    fixed[v] = 1;
    values.row(static_cast<Index>(v)).setConstant(otherwise);
  }
  return solve_fixed(stiffness_matrix(mesh), fixed, MatrixXd::Zero(values.rows(), values.cols()),
                     values);
}

VectorXd nearest_potential(const FlatMesh& mesh, const std::vector<Point2>& field) {
  const std::vector<int> piece = connected_pieces(mesh.triangles, mesh.positions.size());
  std::vector<uint8_t> fixed(piece.size(), 0);
  for (const int first : piece) fixed[first] = 1;
  const auto vertices = static_cast<Index>(piece.size());
  VectorXd potential = solve_fixed(stiffness_matrix(mesh), fixed, divergence_load(mesh, field),
                                   VectorXd::Zero(vertices));
  const VectorXd mass = lumped_mass(mesh);
  VectorXd area = VectorXd::Zero(vertices);
  VectorXd sum = area;
  for (Index v = 0; v < vertices; ++v) {
    area[piece[v]] += mass[v];
    sum[piece[v]] += mass[v] * potential[v];
  }
  for (Index v = 0; v < vertices; ++v) potential[v] -= sum[piece[v]] / area[piece[v]];
  return potential;
}

}  // namespace relievo

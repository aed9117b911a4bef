#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "kernel/base/sparse_matrix.h"

namespace relievo::testing {

/// The lower triangle of a positive definite matrix whose pattern has a telling shape.
struct NamedMatrix {
  std::string name;
  SparseMatrix lower;
};

/// Laplacian of a grid of width x height nodes, plus `shift` on the diagonal; lower triangle.
SparseMatrix grid_laplacian(int width, int height, double shift);

/// One entry, diagonal, tridiagonal, dense, two kinds of arrow, a star of cliques, unconnected
/// grids of different sizes, a long strip, a square grid and random patterns of several densities.
std::vector<NamedMatrix> telling_matrices();

/// The whole symmetric matrix.
Eigen::MatrixXd dense_symmetric(const SparseMatrix& lower);

}  // namespace relievo::testing

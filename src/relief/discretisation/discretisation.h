#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/operators/gradient.h"
#include "relief/discretisation/crease_stencils.h"

namespace relievo {

/// The joined surface as the solvers see it: what its triangulation alone decides, and all stages
/// share.
struct Discretisation {
  double scale = 1;              ///< scene units per px
  SparseMatrix L;                ///< #N x #N, stiffness, both triangles; without flaps
  std::vector<int> surface;      ///< #N, smallest node of the node's joined surface
  Eigen::VectorXd mass;          ///< #N, lumped, scene units^2; 0 inside flaps
  GradientStencils gradients;    ///< at nodes, 1 / px; none inside flaps
  CreaseStencils creases;        ///< at corners beside creases
  std::vector<int> elimination;  ///< nodes in an order in which matrices on them fill in little;
                                 ///< those at one base vertex are consecutive
};

}  // namespace relievo

#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/ordering/depth_system.h"

namespace relievo::relief {

/// The shift energy 1/2 g'A g with f unknown at some free nodes F. The unknowns are those of a
/// depth system and then y = sign f on F, #Z together: g = T (z, y) minus the known part of f.
struct ShiftMatrix {
  SparseMatrix T;                ///< #N x #Z
  SparseMatrix K;                ///< T'A T, lower triangle
  Eigen::VectorXd sign;          ///< #F, 1, or -1 if u is negative on the surface
  Eigen::VectorXd diagonal;      ///< #F, diagonal of T'A T on F
  std::vector<int> elimination;  ///< order of the unknowns with little fill-in

  Eigen::Index heights() const { return T.cols() - diagonal.size(); }
};

/// Makes the matrix for the `nodes` (F). O(N + entries of A).
ShiftMatrix make_shift_matrix(const NonlinearModel& model, const DepthSystem& depth,
                              const std::vector<int>& nodes);

/// Sets the diagonal of K on F to that of T'A T plus `stiffness`, #F.
void set_stiffness(const ShiftMatrix& matrix, const Eigen::VectorXd& stiffness, SparseMatrix& K);

}  // namespace relievo::relief

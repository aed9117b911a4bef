#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/ordering/depth_problem.h"

namespace relievo::relief {

/// The shift energy 1/2 g'A g over unknowns of a depth problem and the f of some nodes, -f where u
/// is negative on the surface: g = T z but for what is fixed, where z holds the former and then the
/// latter. Z = #heights + #soft.
struct SoftMatrix {
  SparseMatrix T;                 ///< #N x #Z
  SparseMatrix K;                 ///< T'A T, lower triangle
  Eigen::VectorXd direction;      ///< #soft, f = direction * unknown
  Eigen::VectorXd own_stiffness;  ///< #soft, the diagonal of K there without springs
  std::vector<int> elimination;   ///< order of the unknowns in which K fills in little

  Eigen::Index heights() const { return T.cols() - own_stiffness.size(); }
};

/// O(N + entries of A).
SoftMatrix make_soft_matrix(const NonlinearModel& model, const DepthProblem& problem,
                            const std::vector<int>& soft);

/// Puts springs on f, one per soft node, in place of those that K has.
void set_springs(const SoftMatrix& matrix, const Eigen::VectorXd& stiffness, SparseMatrix& K);

}  // namespace relievo::relief

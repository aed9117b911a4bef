#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/scene/scene.h"

namespace relievo {

/// What parts that lean add to the cost of a shift; scene units.
struct LeanTerm {
  Eigen::VectorXd pull;  ///< #N, 0 where no part leans
  double constant = 0;   ///< of the cost, so that it is 0 where all parts have their lean

  /// Twice the cost of g is this beyond g'(A g - pull), the work of its force.
  double rest(const Eigen::VectorXd& g) const { return 2 * constant - g.dot(pull); }
};

/// What a shift g costs: 1/2 g'A g - g'pull + constant in scene units [P eq 10]. It is
///   1/2 sum over parts of integral |grad g - t|^2 + epsilon |g - t . (x - m)|^2,
/// t the lean of the part and m the middle of its faces, masses lumped.
struct ShiftMetric {
  double scale = 1;  ///< scene units per px
  SparseMatrix A;    ///< L + epsilon M, both triangles
  LeanTerm lean;
};

/// That of parts which do not lean. O(entries of L).
ShiftMetric make_shift_metric(const Discretisation& discretisation, double epsilon);

/// Does not change the matrix. `scale`: scene units per px. O(N + F).
LeanTerm lean_term(const LayeredMesh& mesh, const Scene& scene, double scale, double epsilon);

/// f = sgn(u) sqrt|u| at each node, in the root of the unit of u.
Eigen::VectorXd inflated_heights(const std::vector<double>& u);

}  // namespace relievo

#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/geometry/polygon.h"
#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// What parts that lean, or have slopes or creases, add to the cost of a shift g with the metric
/// A = L + epsilon M: 1/2 g'A g - g'pull + constant, in scene units, is
///   1/2 sum over parts of integral |grad g - v|^2 + epsilon |g - r|^2,
/// v the slope field of the part, r its rise + const, masses lumped: t and t . x + const where all
/// that it has is a lean t. The constants are those by which the r of parts that cover each other
/// differ least on average where they do, with mean 0 over such parts: what lies loose on a part
/// that leans goes along.
struct LeanTerm {
  Eigen::VectorXd pull;  ///< #N, 0 where no part has slopes
  double constant = 0;

  /// Twice the cost of g is this beyond g'(A g - pull), the work of its force.
  double rest(const Eigen::VectorXd& g) const { return 2 * constant - g.dot(pull); }
};

/// `scale`: scene units per px. O(N + F), and where there are slopes, those of slope_field and
/// one for the graph of parts that cover each other.
LeanTerm lean_term(const LayeredMesh& mesh, const Scene& scene, double scale, double epsilon);

/// What a shift g costs: 1/2 g'A g in scene units [P eq 10], and what leaning parts and limbs add.
struct ShiftMetric {
  double scale = 1;  ///< scene units per px
  SparseMatrix A;    ///< L + epsilon M, both triangles
  LeanTerm lean;
};

/// That of parts which do not lean, and are no limbs. O(entries of L).
ShiftMetric make_shift_metric(const Discretisation& discretisation, double epsilon);

/// The shift r (#N, scene units) is wanted besides: every g costs what g - r did. O(entries of A).
void add_wanted(const Eigen::VectorXd& r, ShiftMetric& metric);

/// f = sgn(u) sqrt|u| at each node, in the root of the unit of u.
Eigen::VectorXd inflated_heights(const std::vector<double>& u);

}  // namespace relievo::relief

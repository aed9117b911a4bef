#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The cost 1/2 g'A g - b'g + constant of a shift g, in scene units [P eq 10].
struct ShiftMetric {
  double scale = 1;     ///< scene units per px
  SparseMatrix A;       ///< L + epsilon M, both triangles
  Eigen::VectorXd b;    ///< #N, 0 where no shift is wanted
  double constant = 0;  ///< makes the cost 0 for a shift that is exactly as wanted

  /// Returns 2 constant - b'g. Twice the cost of g is g'(A g - b) plus this.
  double rest(const Eigen::VectorXd& g) const { return 2 * constant - g.dot(b); }
};

/// Makes the metric with b = 0. O(entries of L).
ShiftMetric make_shift_metric(const Discretisation& discretisation, double epsilon);

/// Sets b and the constant for the slopes that leans (tilted parts), slope cues and creases ask
/// for. With t the slope field of a part and r its potential, the cost becomes
///   1/2 sum over parts of integral |grad g - t|^2 + epsilon |g - r|^2,    masses lumped.
/// r is known up to a constant for each part. The constants minimise the mean differences of r
/// between parts that cover each other, so that a loose part follows the part that it lies on;
/// their mean is 0 over such parts. `metric` must be made with `epsilon`. O(N + F); with slopes
/// also slope_field and a factorisation for the graph of parts.
void set_slopes(const LayeredMesh& mesh, const Scene& scene, double epsilon, ShiftMetric& metric);

/// Makes r (#N, scene units) a wanted shift: g now costs what g - r did. O(entries of A).
void add_wanted(const Eigen::VectorXd& r, ShiftMetric& metric);

/// Returns f = sgn(u) sqrt|u| at each node, in the root of the unit of u.
Eigen::VectorXd inflated_heights(const std::vector<double>& u);

}  // namespace relievo::relief

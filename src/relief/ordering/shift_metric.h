#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "relief/discretisation/discretisation.h"
#include "relief/ordering/lean_term.h"

namespace relievo {

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

}  // namespace relievo

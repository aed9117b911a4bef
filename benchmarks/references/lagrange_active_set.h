#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::benchmarks {

struct ReferenceSolution {
  Eigen::VectorXd x;
  int iterations = 0;
  bool solved = false;
};

/// Minimises 1/2 (h - f)'A (h - f) under the pairs by an active-set method with Lagrange
/// multipliers and a general sparse solver [P §3.2, Jacobson et al. 2013]: merges no unknowns, and
/// factorises the whole system [A C'; C 0] from scratch by sparse LU in each step. Precondition:
/// the pairs form no cycles.
ReferenceSolution solve_with_multipliers(const SparseMatrix& A, const Eigen::VectorXd& f,
                                         const std::vector<relief::DepthPair>& pairs);

}  // namespace relievo::benchmarks

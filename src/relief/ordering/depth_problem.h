#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/solvers/bound_qp.h"
#include "relief/ordering/depth_forest.h"
#include "relief/ordering/ordering.h"
#include "relief/ordering/shift_metric.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// Heights as h = T z, where z holds for each node its height if it is a root, and else its gap.
struct GapVariables {
  std::vector<uint8_t> bounded;  ///< #N: 1 for gaps that are >= 0
  std::vector<uint8_t> fixed;    ///< #N: 1 for gaps that are 0
  SparseMatrix T;                ///< #N x #N, entries 1, -1 and 0

  bool is_root(int node) const { return bounded[node] == 0 && fixed[node] == 0; }
};

/// A row of T has an entry for each node of the row's group, so that the pattern does not depend on
/// which of them is linked to which. O(N + entries of T).
GapVariables make_gap_variables(const DepthForest& forest);

/// Heights of the nodes from the heights of the roots (read at the roots in `root_height`, #N) and
/// the gaps `z` times `unit` (#N). Adds along the trees, so that no pair of the forest is violated,
/// not even by round-off. O(N).
std::vector<double> heights_from_gaps(const DepthForest& forest, const Eigen::VectorXd& root_height,
                                      const Eigen::VectorXd& z, double unit);

/// Depth pairs as unknowns: heights are h = T z with gaps z >= 0.
struct DepthProblem {
  DepthForest forest;
  GapVariables variables;
};

/// Costs as build_depth_forest and make_gap_variables.
DepthProblem make_depth_problem(const std::vector<int>& node_part,
                                const std::vector<DepthPair>& pairs);

/// f at the roots and 0 at the gaps, #N. Counting from there keeps the unknowns small, and
/// exactly 0 where nothing pushes.
Eigen::VectorXd root_heights(const DepthProblem& problem, const Eigen::VectorXd& f);

/// f beyond the heights that those give all nodes while every gap is 0, #N.
Eigen::VectorXd beyond_roots(const DepthProblem& problem, const Eigen::VectorXd& f);

/// #N: 1 for the gaps that heights h leave closed.
std::vector<uint8_t> closed_gaps(const DepthProblem& problem, const std::vector<double>& h);

/// Heights in px from the heights of the roots (px) and the unknowns in scene units: the roots'
/// shifts and the gaps.
std::vector<double> heights_of(const DepthProblem& problem, const Eigen::VectorXd& root_height,
                               const Eigen::VectorXd& unknowns, double scale);

/// A depth problem as a quadratic program with the factor of its matrix K = T'A T.
struct DepthSystem {
  DepthProblem problem;
  BoundQp qp;                   ///< b is that of the last solution
  SparseCholesky factor;        ///< analysed incrementally
  std::vector<uint8_t> closed;  ///< gaps to begin with closed, then those of the solution; or empty
};

/// Makes the problem that of the system, with the matrix for it; the factor is none of it, and no
/// gap is known to be closed. O(products of galerkin_lower).
void set_problem(DepthProblem problem, const ShiftMetric& metric, DepthSystem& system);

/// `elimination` holds the nodes in an order that fills in little; where it is empty, one is
/// chosen. Uses the memory of `factor`. Near-linear in the entries of K and of the fronts' rows.
DepthSystem make_depth_system(DepthProblem problem, const ShiftMetric& metric,
                              const std::vector<int>& elimination, SparseCholesky factor,
                              const RunContext& context);

/// Minimises the metric's cost of h - f under the pairs, f in px. Writes h, the counts and the
/// report of `ordering`. One factorisation per iteration, of what changes.
SolveStatus solve_heights(DepthSystem& system, const ShiftMetric& metric, const Eigen::VectorXd& f,
                          Ordering& ordering, const RunContext& context);

}  // namespace relievo::relief

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <tuple>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/solvers/active_set.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/depth_forest.h"
#include "relief/ordering/ordering.h"
#include "relief/ordering/shift_metric.h"
#include "relievo/point.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// The depth order as a bound-constrained quadratic program over z: the heights of the roots of a
/// forest and the gaps of all other nodes.
struct DepthSystem {
  DepthForest forest;
  SparseMatrix T;               ///< #N x #N, h = T z; entries 1, -1 and 0
  BoundQp qp;                   ///< K = T'A T; gaps are bounded or fixed; b of the last solve
  SparseCholesky factor;        ///< analysed incrementally
  std::vector<uint8_t> closed;  ///< #N: gaps of the first active set, then of the last; or empty

  bool is_root(int node) const { return qp.bounded[node] == 0 && qp.fixed[node] == 0; }
};

/// Returns the heights f of the roots and 0 for the gaps, #N. The unknowns z are counted from here:
/// that keeps them small, and exactly 0 where no pair acts.
Eigen::VectorXd root_heights(const DepthForest& forest, const Eigen::VectorXd& f);

/// Returns f minus the heights that all nodes have if every gap is 0 and roots are at f, #N.
Eigen::VectorXd beyond_roots(const DepthSystem& system, const Eigen::VectorXd& f);

/// Returns #N flags: 1 for the gaps that are closed at heights h.
std::vector<uint8_t> closed_gaps(const DepthForest& forest, const std::vector<double>& h);

/// Returns heights in px, #N, from `roots` (px, read at roots) and the unknowns z in scene units:
/// shifts of the roots and gaps. Adds along the trees, so that no pair is violated, not even by
/// round-off. `scale`: scene units per px. O(N).
std::vector<double> heights_of(const DepthSystem& system, const Eigen::VectorXd& roots,
                               const Eigen::VectorXd& z, double scale);

/// Sets the forest, T, K and the bounds. Clears the active set, and marks the factor as stale. A
/// row of T has an entry for each node of its group, so that the pattern does not depend on which
/// of them are linked. O(products of galerkin_lower).
void set_forest(DepthForest forest, const ShiftMetric& metric, DepthSystem& system);

/// Makes a system and analyses its matrix. `elimination` orders the nodes for little fill-in; if it
/// is empty, an order is computed. Reuses the memory of `factor`. Near-linear in the entries of K
/// and of the fronts' rows.
DepthSystem make_depth_system(DepthForest forest, const ShiftMetric& metric,
                              const std::vector<int>& elimination, SparseCholesky factor,
                              const RunContext& context);

/// Minimises the metric's cost of h - f under the pairs, f in px. Writes h, the counts and the
/// report of `ordering`. Every iteration factorises what the active set changes.
SolveStatus solve_heights(DepthSystem& system, const ShiftMetric& metric, const Eigen::VectorXd& f,
                          Ordering& ordering, const RunContext& context);

/// A point where two parts may touch: a depth pair that does not depend on the mesh.
struct DepthContact {
  int lower = -1;       ///< part
  int upper = -1;       ///< part
  bool inside = false;  ///< whether both nodes lie off outlines
  Point2 position;      ///< px
  bool closed = false;  ///< whether the nodes have the same height, or cross

  std::tuple<int, int, bool> group() const { return {lower, upper, inside}; }
};

/// Returns the contacts of heights h (#N) at the inequalities of the mesh. They depend on the
/// heights alone, not on the active set of the solver. O(constraints).
std::vector<DepthContact> contacts_of(const LayeredMesh& mesh, const std::vector<double>& h);

/// Returns a first active set, #N flags, from the contacts of a similar scene on another mesh. Each
/// gap is closed if the nearest contact of the same parts and kind is, and open if there is none.
/// O(gaps log contacts) unless contacts are stacked above each other on the canvas.
std::vector<uint8_t> gaps_like(const LayeredMesh& mesh, const DepthForest& forest,
                               std::vector<DepthContact> contacts);

}  // namespace relievo::relief

#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "relief/inflation/inflation.h"
#include "relief/nonlinear/nonlinear_solution.h"
#include "relief/ordering/depth_forest.h"
#include "relief/ordering/order_depth.h"
#include "relief/ordering/shift_metric.h"

namespace relievo {

/// The non-linear problem in scene units, without its depth pairs.
struct NonlinearModel {
  double lambda_bnd = 1;
  double lambda_shift = 1;
  ShiftMetric metric;            ///< of the shift
  SparseMatrix L;                ///< #N x #N, with the screening of flat parts
  Eigen::VectorXd mass;          ///< #N
  Eigen::VectorXd load;          ///< #N, M c
  std::vector<int> elimination;  ///< nodes in an order in which matrices on them fill in little
  std::vector<int> sign;         ///< #N, of u: 1, -1, or 0 where both occur
  std::vector<int> place;        ///< #N: row of the node in `inner`, -1 on outlines and B
  std::vector<int> inner;        ///< nodes whose u is free, ascending
  std::vector<int> bound;        ///< nodes of B, ascending
  /// #B, where nothing but an inequality lifts f: the child of the gap that opens once f is 0; else
  /// -1, as everywhere before find_loose_bound.
  std::vector<int> loose_gap;
  Eigen::VectorXd held;         ///< #N, u where it is neither free nor on B; 0 elsewhere
  Eigen::VectorXd bound_mass;   ///< #B, lengths of outline that they stand for
  std::vector<int> bound_ramp;  ///< #B, a range that they lie under
};

/// B are the nodes under Robin ranges that pairs tie to another part or may lift. Of the others
/// under ranges, those that are seen have u = 0, as free nodes where it is 0 in the input, and
/// those that are hidden keep the u of the input. `metric`: with its leans. O(N + F).
NonlinearModel make_joint_model(const OrderingInput& input, const ShiftMetric& metric);

/// Finds where B is loose. O(N).
void find_loose_bound(const DepthForest& forest, NonlinearModel& model);

/// Whether u may have either sign somewhere. O(N).
bool is_mixed(const NonlinearModel& model);

/// Holds the nodes where u has not the sign of its surface at 0 from now on; false where there are
/// none. O(N).
bool hold_wrong_signs(const Eigen::VectorXd& u, NonlinearModel& model);

/// The energy at any u and g in scene units, #N each. O(N).
NonlinearEnergy nonlinear_energy(const NonlinearModel& model, const Eigen::VectorXd& u,
                                 const Eigen::VectorXd& g);

}  // namespace relievo

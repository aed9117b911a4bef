#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "relief/inflation/inflation.h"
#include "relief/nonlinear/nonlinear_solution.h"
#include "relief/ordering/depth_forest.h"
#include "relief/ordering/order_depth.h"
#include "relief/ordering/shift_metric.h"

namespace relievo::relief {

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

/// How far the inflation exceeds c under a load.
struct Excess {
  Eigen::VectorXd s;      ///< #N, M^-1 L u - c
  Eigen::VectorXd slope;  ///< #B, derivative of the inflation energy / 2 with respect to u there
  double energy = 0;
};

/// Minimises the inflation energy minus twice a linear load over u off B: two Poisson solves with
/// one factor, for the biharmonic matrix is L M^-1 L.
class InflationResponse {
 public:
  explicit InflationResponse(const NonlinearModel& model);

  /// False where the Poisson problem has no unique solution.
  bool sound() const { return sound_; }

  const NonlinearModel& model() const { return model_; }

  /// load: #N, read at inner nodes.
  Excess excess(const Eigen::VectorXd& load) const;

  /// The u (#N) that has this excess and, on B, u_bound (#B).
  Eigen::VectorXd inflate(const Excess& excess, const Eigen::VectorXd& u_bound) const;

  /// How u answers to a load alone. #N
  Eigen::VectorXd compliance(const Eigen::VectorXd& load) const;

 private:
  Eigen::VectorXd with_bound(Eigen::VectorXd u, const Eigen::VectorXd& u_bound) const;
  void subtract_bound(const Eigen::VectorXd& u_bound, Eigen::VectorXd& load) const;
  Eigen::VectorXd solve_poisson(const Eigen::VectorXd& load) const;

  const NonlinearModel& model_;
  Eigen::VectorXd own_load_;  ///< #N, without B and the excess
  SparseCholesky factor_;
  bool sound_ = false;
};

/// f = sgn(u) sqrt|u| and its inverse, in scene units. The slope of the root has no bound at 0;
/// with a width w > 0 it is at most 1/w: f = u / (u^2 + w^4)^(1/4), the same to (w / f)^4 / 4.
class SmoothRoot {
 public:
  explicit SmoothRoot(double width = 0) : w4_(width * width * width * width) {}

  double f(double u) const {
    if (w4_ == 0) return signed_root(u);
    return u / std::sqrt(std::sqrt(u * u + w4_));
  }

  /// df / du; of the sharp root as at |f| = smallest_f where |f| is less.
  double slope(double u) const {
    if (w4_ == 0) return 1 / (2 * std::max(std::sqrt(std::abs(u)), smallest_f));
    const double s = u * u + w4_;
    return (u * u / 2 + w4_) / (s * std::sqrt(std::sqrt(s)));
  }

  /// The u whose root is f.
  double u(double f) const {
    const double f4 = f * f * f * f;
    return std::copysign(std::sqrt((f4 + std::sqrt(f4 * (f4 + 4 * w4_))) / 2), f);
  }

 private:
  static constexpr double smallest_f = 1e-3;
  double w4_;
};

}  // namespace relievo::relief

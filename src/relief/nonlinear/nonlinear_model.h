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
#include "relief/ordering/depth_system.h"
#include "relief/ordering/shift_metric.h"

namespace relievo::relief {

/// The non-linear problem without its depth pairs, in scene units.
struct NonlinearModel {
  double lambda_bnd = 1;
  double lambda_shift = 1;
  ShiftMetric metric;            ///< A = L + epsilon M, and b
  SparseMatrix L;                ///< #N x #N, with the screening of flat parts
  Eigen::VectorXd mass;          ///< #N, M
  Eigen::VectorXd load;          ///< #N, M c
  std::vector<int> elimination;  ///< nodes in an order with little fill-in
  std::vector<int> sign;         ///< #N, sign of u: 1, -1, or 0 if both occur on the surface
  std::vector<int> inner;        ///< I: nodes whose u is free, ascending
  std::vector<int> inner_index;  ///< #N: index of the node in `inner`, or -1
  std::vector<int> bound;        ///< B: nodes whose f lambda_bnd pulls to 0, ascending
  Eigen::VectorXd bound_mass;    ///< #B, m: length of outline that the node stands for
  std::vector<int> bound_ramp;   ///< #B, a Robin range that the node lies under
  /// #B, for nodes where only an inequality lifts f: the child of its gap, which opens once f is 0.
  /// -1 for the other nodes, and before find_lifting_gaps.
  std::vector<int> lifting_gap;
  Eigen::VectorXd fixed_u;  ///< #N, u of the nodes that are neither in I nor on B; 0 elsewhere
};

/// Makes the model of a start. B are the nodes under Robin ranges that depth pairs tie to another
/// part or may lift. At the other nodes under ranges u is fixed: at 0 if they are seen, otherwise
/// at its value in the start. Nodes off ranges whose u is 0 in the start stay at 0. `metric`: with
/// its wanted shifts. O(N + F).
NonlinearModel make_joint_model(const SurfaceInput& surface, const Inflation& start,
                                const ShiftMetric& metric);

/// Finds the nodes of B that only an inequality lifts. O(N).
void find_lifting_gaps(const DepthForest& forest, NonlinearModel& model);

/// Checks whether u may have either sign on some surface. O(N).
bool is_mixed(const NonlinearModel& model);

/// Removes the nodes from I where u has the wrong sign, which fixes them at 0. Returns whether
/// there were any. O(N).
bool fix_wrong_signs(const Eigen::VectorXd& u, NonlinearModel& model);

/// Computes the energy of u and g, #N each in scene units. O(N).
NonlinearEnergy nonlinear_energy(const NonlinearModel& model, const Eigen::VectorXd& u,
                                 const Eigen::VectorXd& g);

/// The inflation energy minimised over u on I, for given loads on u and given u on B. It costs two
/// Poisson solves with one factor, because the biharmonic matrix is L M^-1 L.
class InflationResponse {
 public:
  /// Factorises L_II.
  explicit InflationResponse(const NonlinearModel& model);

  /// Returns whether the Poisson problem has a unique solution.
  bool is_solvable() const { return is_solvable_; }

  const NonlinearModel& model() const { return model_; }

  /// Solves L_II s = phi for the excess s = M^-1 L u - c, #N, 0 off I. `phi`: #N, read on I.
  Eigen::VectorXd excess(const Eigen::VectorXd& phi) const { return solve_poisson(phi); }

  /// Returns L_BI s, #B: half the derivative of the inflation energy with respect to u on B.
  Eigen::VectorXd boundary_slope(const Eigen::VectorXd& s) const;

  /// Returns the inflation energy s'M s.
  double energy(const Eigen::VectorXd& s) const { return s.dot(model_.mass.cwiseProduct(s)); }

  /// Returns the u (#N) with excess s on I and u_bound (#B) on B.
  Eigen::VectorXd inflate(const Eigen::VectorXd& s, const Eigen::VectorXd& u_bound) const;

  /// Returns the change L_II^-1 M L_II^-1 phi of u by a load, #N.
  Eigen::VectorXd compliance(const Eigen::VectorXd& phi) const;

 private:
  Eigen::VectorXd solve_poisson(const Eigen::VectorXd& load) const;

  const NonlinearModel& model_;
  Eigen::VectorXd fixed_load_;  ///< #N, M c - L fixed_u
  SparseCholesky factor_;       ///< of L_II
  bool is_solvable_ = false;
};

/// f = sgn(u) sqrt|u| and its inverse, in scene units. The slope of the root is unbounded at 0.
/// With a width w > 0 it is at most 1/w: f = u / (u^2 + w^4)^(1/4), which is the root up to a
/// relative error of (w / f)^4 / 4.
class SmoothRoot {
 public:
  explicit SmoothRoot(double width = 0) : w4_(width * width * width * width) {}

  double f(double u) const {
    if (w4_ == 0) return signed_root(u);
    return u / std::sqrt(std::sqrt(u * u + w4_));
  }

  /// Returns df / du. For w = 0 the slope is that at |f| = smallest_f if |f| is smaller.
  double slope(double u) const {
    if (w4_ == 0) return 1 / (2 * std::max(std::sqrt(std::abs(u)), smallest_f));
    const double s = u * u + w4_;
    return (u * u / 2 + w4_) / (s * std::sqrt(std::sqrt(s)));
  }

  /// Returns the u whose root is f.
  double u(double f) const {
    const double f4 = f * f * f * f;
    return std::copysign(std::sqrt((f4 + std::sqrt(f4 * (f4 + 4 * w4_))) / 2), f);
  }

 private:
  static constexpr double smallest_f = 1e-3;
  double w4_;
};

/// The shift energy 1/2 g'A g with f unknown at some free nodes F. The unknowns are those of a
/// depth system and then y = sign f on F, #Z together: g = T (z, y) minus the known part of f.
struct ShiftMatrix {
  SparseMatrix T;                ///< #N x #Z
  SparseMatrix K;                ///< T'A T, lower triangle
  Eigen::VectorXd sign;          ///< #F, 1, or -1 if u is negative on the surface
  Eigen::VectorXd diagonal;      ///< #F, diagonal of T'A T on F
  std::vector<int> elimination;  ///< order of the unknowns with little fill-in

  Eigen::Index heights() const { return T.cols() - diagonal.size(); }
};

/// Makes the matrix for the `nodes` (F). O(N + entries of A).
ShiftMatrix make_shift_matrix(const NonlinearModel& model, const DepthSystem& depth,
                              const std::vector<int>& nodes);

/// Sets the diagonal of K on F to that of T'A T plus `stiffness`, #F.
void set_stiffness(const ShiftMatrix& matrix, const Eigen::VectorXd& stiffness, SparseMatrix& K);

}  // namespace relievo::relief

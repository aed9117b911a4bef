#pragma once

#include <Eigen/Core>

#include "kernel/solvers/sparse_cholesky.h"
#include "relief/nonlinear/nonlinear_model.h"

namespace relievo {

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

}  // namespace relievo

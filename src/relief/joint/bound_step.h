#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/base/run_context.h"
#include "kernel/solvers/bound_qp.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/joint/joint_model.h"
#include "relief/joint/soft_matrix.h"
#include "relief/ordering/depth_problem.h"

namespace relievo {

/// Steps of f on B against the slope of the energy, by the stiffness that f would have if nothing
/// but equalities held the heights: like that of the energy itself it grows with the wave number
/// along B, whether a part lies on another beside B or not.
class BoundStep {
 public:
  BoundStep(const JointModel& model, const DepthProblem& problem);

  /// Takes f (#B) to the next one; where u has one sign, it does not pass 0. `slope`: #B, of the
  /// energy / 2 with respect to f; `springs`: #B, what else resists f, positive. Factorises when
  /// the springs are no longer those of the last factor.
  SolveStatus move(const Eigen::VectorXd& slope, const Eigen::VectorXd& springs,
                   const RunContext& context, Eigen::VectorXd& f);

 private:
  void renew_springs(const Eigen::VectorXd& stiffness);

  const JointModel& model_;
  SoftMatrix matrix_;
  BoundQp qp_;
  Eigen::VectorXd springs_;  ///< in K, in units of lambda_shift; empty at first
  std::vector<uint8_t> active_;
  SparseCholesky factor_;
};

}  // namespace relievo

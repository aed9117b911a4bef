#include "relief/joint/bound_step.h"

namespace relievo {

using Eigen::VectorXd;

namespace {

/// The matrix serves as long as no spring has changed by so much of the stiffness there.
constexpr double tolerated_change = 0.1;

/// It only leads the way.
constexpr double step_tolerance = 1e-9;

}  // namespace

BoundStep::BoundStep(const JointModel& model, const DepthProblem& problem)
    : model_(model), matrix_(make_soft_matrix(model, problem, model.bound)) {
  if (model.bound.empty()) return;
  qp_.K.swap(matrix_.K);
  qp_.bounded.assign(static_cast<size_t>(matrix_.T.cols()), 0);
  for (size_t i = 0; i < model.bound.size(); ++i)
    qp_.bounded[matrix_.heights() + i] = model.sign[model.bound[i]] != 0;
  factor_.analyse(qp_.K, Refactorisation::incremental, matrix_.elimination);
}

void BoundStep::renew_springs(const VectorXd& stiffness) {
  if (springs_.size() > 0) {
    const auto change = (stiffness - springs_).cwiseAbs().array();
    if ((change <= tolerated_change * (matrix_.own_stiffness + springs_).array()).all()) return;
  }
  springs_ = stiffness;
  set_springs(matrix_, stiffness, qp_.K);
}

SolveStatus BoundStep::move(const VectorXd& slope, const VectorXd& springs,
                            const RunContext& context, VectorXd& f) {
  if (f.size() == 0) return SolveStatus::solved;
  renew_springs(springs / model_.lambda_shift);
  VectorXd z = VectorXd::Zero(matrix_.T.cols());
  z.tail(f.size()) = matrix_.direction.cwiseProduct(f);
  qp_.b = multiply_symmetric(qp_.K, z);
  qp_.b.tail(f.size()) -= matrix_.direction.cwiseProduct(slope) / model_.lambda_shift;
  BoundQpOptions options;
  options.start_active = active_;
  options.tolerance = step_tolerance;
  const BoundQpSolution solution = solve_bound_qp(qp_, factor_, options, context);
  active_ = solution.active;
  f = matrix_.direction.cwiseProduct(solution.z.tail(f.size()));
  return solution.report.status;
}

}  // namespace relievo

#include "relief/joint/contact_step.h"

#include <utility>

namespace relievo {

using Eigen::VectorXd;

namespace {

/// The order of the solution is found again, exactly.
constexpr double contact_tolerance = 1e-11;

/// A g - pull where gaps press with mu: exactly 0 where none do, so that solves pass over it. #N
VectorXd forces_of_gaps(const DepthForest& forest, const VectorXd& mu) {
  VectorXd force = VectorXd::Zero(mu.size());
  for (const DepthGap& gap : forest.gaps) {
    force[gap.child] += gap.sign * mu[gap.child];
    force[gap.parent] -= gap.sign * mu[gap.child];
  }
  return force;
}

}  // namespace

ContactStep::ContactStep(const JointModel& model, const DepthProblem& problem,
                         const std::vector<int>& soft, const std::vector<uint8_t>& closed)
    : model_(model),
      problem_(problem),
      matrix_(make_soft_matrix(model, problem, soft)),
      active_(closed) {
  qp_.bounded = problem.variables.bounded;
  qp_.fixed = problem.variables.fixed;
  qp_.bounded.resize(qp_.bounded.size() + soft.size(), 0);
  qp_.fixed.resize(qp_.bounded.size(), 0);
  active_.resize(qp_.bounded.size(), 0);
  qp_.K.swap(matrix_.K);
}

bool ContactStep::prepare(const RunContext& context) {
  return factor_.analyse(qp_.K, Refactorisation::incremental, matrix_.elimination, context);
}

Contact ContactStep::solve(const VectorXd& f, const Springs& springs, const RunContext& context) {
  const Eigen::Index softs = springs.pull.size();
  const LeanTerm& lean = model_.metric.lean;
  const VectorXd root_height = root_heights(problem_, f);
  const VectorXd rest = f - problem_.variables.T * root_height;
  qp_.b = matrix_.T.transpose() * (model_.metric.A * rest + lean.pull);
  qp_.b.tail(softs) += matrix_.direction.cwiseProduct(springs.pull) / model_.lambda_shift;
  set_springs(matrix_, springs.stiffness / model_.lambda_shift, qp_.K);
  BoundQpOptions options;
  options.start_active = active_;
  options.tolerance = contact_tolerance;
  options.start = std::move(last_);
  options.same_matrix = options.start.size() > 0 && softs == 0;
  const BoundQpSolution solution = solve_bound_qp(qp_, factor_, std::move(options), context);
  active_ = solution.active;
  last_ = solution.z;

  Contact contact;
  contact.status = solution.report.status;
  contact.factorisations = solution.report.factorisations;
  contact.soft = matrix_.direction.cwiseProduct(solution.z.tail(softs));
  const VectorXd g = matrix_.T * solution.z - rest;
  contact.force = softs > 0 ? VectorXd(model_.metric.A * g - lean.pull)
                            : forces_of_gaps(problem_.forest, solution.mu);
  contact.force *= model_.lambda_shift;
  contact.shift_energy = g.dot(contact.force) + model_.lambda_shift * lean.rest(g);
  const double scale = model_.metric.scale;
  contact.h = heights_of(problem_, root_height / scale, solution.z, scale);
  return contact;
}

std::optional<DepthSystem> ContactStep::release() && {
  if (matrix_.direction.size() > 0) return std::nullopt;
  return DepthSystem{problem_, std::move(qp_), std::move(factor_), std::move(active_), false, {}};
}

}  // namespace relievo

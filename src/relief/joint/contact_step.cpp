#include "relief/joint/contact_step.h"

#include "kernel/operators/laplacian.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// T with one more column for each soft node.
SparseMatrix with_soft_columns(const SparseMatrix& T, const std::vector<SoftNode>& soft,
                               const VectorXd& direction) {
  const int heights = static_cast<int>(T.cols());
  SparseMatrix wide(static_cast<int>(T.rows()), heights + static_cast<int>(soft.size()));
  wide.reserve(T.nonZeros() + direction.size());
  for (int j = 0; j < heights; ++j) {
    wide.startVec(j);
    for (SparseMatrix::InnerIterator entry(T, j); entry; ++entry)
      wide.insertBack(static_cast<int>(entry.row()), j) = entry.value();
  }
  for (int i = 0; i < static_cast<int>(soft.size()); ++i) {
    wide.startVec(heights + i);
    wide.insertBack(soft[i].node, heights + i) = -direction[i];
  }
  wide.finalize();
  return wide;
}

/// The variables of the problem and the soft nodes' f in the order of elimination.
std::vector<int> order_of_unknowns(const JointModel& model, const DepthProblem& problem,
                                   const std::vector<SoftNode>& soft) {
  const std::vector<int>& variable = problem.variables.variable;
  const int heights = static_cast<int>(problem.variables.bounded.size());
  std::vector<int> soft_at(model.elimination.size(), -1);
  for (size_t i = 0; i < soft.size(); ++i) soft_at[soft[i].node] = heights + static_cast<int>(i);
  std::vector<uint8_t> seen(problem.variables.bounded.size(), 0);
  std::vector<int> order;
  order.reserve(seen.size() + soft.size());
  for (const int n : model.elimination) {
    if (seen[variable[n]] == 0) order.push_back(variable[n]);
    seen[variable[n]] = 1;
    if (soft_at[n] >= 0) order.push_back(soft_at[n]);
  }
  return order;
}

}  // namespace

ContactStep::ContactStep(const JointModel& model, const DepthProblem& problem,
                         const std::vector<SoftNode>& soft, const std::vector<double>& last_h)
    : model_(model), problem_(problem) {
  const auto softs = static_cast<Eigen::Index>(soft.size());
  qp_.bounded = problem.variables.bounded;
  if (!last_h.empty()) active_ = closed_gaps(problem, last_h);
  active_.resize(qp_.bounded.size() + soft.size(), 0);
  direction_ = VectorXd::Ones(softs);
  for (Eigen::Index i = 0; i < softs; ++i) {
    if (soft[i].sign < 0) direction_[i] = -1;
    qp_.bounded.push_back(soft[i].sign != 0);
  }
  T_ = with_soft_columns(problem.variables.T, soft, direction_);
  qp_.K = galerkin_lower(model.lambda_shift * model.metric.A, T_);
  own_stiffness_ = qp_.K.diagonal().tail(softs);
  factor_.analyse(qp_.K, Refactorisation::incremental, order_of_unknowns(model, problem, soft));
}

Contact ContactStep::solve(const VectorXd& f, const Springs& springs, const RunContext& context) {
  const Eigen::Index softs = direction_.size();
  const int heights = static_cast<int>(T_.cols() - softs);
  const VectorXd root_height = root_heights(problem_, f);
  const VectorXd rest = f - problem_.variables.T * root_height;
  qp_.b = model_.lambda_shift * (T_.transpose() * (model_.metric.A * rest));
  qp_.b.tail(softs) += direction_.cwiseProduct(springs.pull);
  for (Eigen::Index i = 0; i < softs; ++i) {
    const int j = heights + static_cast<int>(i);
    qp_.K.coeffRef(j, j) = own_stiffness_[i] + springs.stiffness[i];
  }
  BoundQpOptions options;
  options.start_active = active_;
  const BoundQpSolution solution = solve_bound_qp(qp_, factor_, options, context);
  active_ = solution.active;

  Contact contact;
  contact.status = solution.report.status;
  contact.factorisations = solution.report.factorisations;
  contact.soft = direction_.cwiseProduct(solution.z.tail(softs));
  const VectorXd g = T_ * solution.z - rest;
  contact.force = model_.lambda_shift * (model_.metric.A * g);
  contact.shift_energy = g.dot(contact.force);
  const double scale = model_.metric.scale;
  contact.h = heights_of(problem_, root_height / scale, solution.z, scale);
  return contact;
}

}  // namespace relievo

#include "relief/joint/contact_step.h"

#include <numeric>
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

/// A v, at the cost of the columns where v is not 0.
VectorXd multiply_where_set(const SparseMatrix& A, const VectorXd& v) {
  VectorXd product = VectorXd::Zero(A.rows());
  for (int j = 0; j < A.outerSize(); ++j)
    if (v[j] != 0)
      for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
        product[entry.row()] += entry.value() * v[j];
  return product;
}

}  // namespace

ContactStep::ContactStep(const JointModel& model, DepthSystem& order, const std::vector<int>& soft)
    : model_(model),
      problem_(order.problem),
      has_soft_(!soft.empty()),
      system_(has_soft_ ? own_ : order),
      T_(has_soft_ ? matrix_.T : problem_.variables.T) {
  if (has_soft_)
    soften(soft, order.closed);
  else
    begin_flat();
}

/// The solution where f is 0 and all gaps are closed; nothing but leans pulls at it.
void ContactStep::begin_flat() {
  last_f_ = VectorXd::Zero(model_.mass.size());
  last_ = VectorXd::Zero(T_.cols());
  last_gradient_ = -(T_.transpose() * model_.metric.lean.pull);
}

void ContactStep::soften(const std::vector<int>& soft, const std::vector<uint8_t>& closed) {
  std::vector<int> heights(model_.elimination.size());
  std::iota(heights.begin(), heights.end(), 0);
  matrix_ = make_soft_matrix(model_, problem_, heights, soft);
  BoundQp& qp = own_.qp;
  qp.bounded = problem_.variables.bounded;
  qp.fixed = problem_.variables.fixed;
  own_.closed = closed;
  const auto unknowns = static_cast<size_t>(matrix_.T.cols());
  for (std::vector<uint8_t>* flags : {&qp.bounded, &qp.fixed, &own_.closed})
    flags->resize(unknowns, 0);
  qp.K.swap(matrix_.K);
}

bool ContactStep::prepare(const RunContext& context) {
  if (!has_soft_) return !context.cancelled();
  return own_.factor.analyse(own_.qp.K, Refactorisation::incremental, matrix_.elimination, context);
}

Contact ContactStep::solve(const VectorXd& f, const Springs& springs, const RunContext& context) {
  const double lambda = model_.lambda_shift;
  const LeanTerm& lean = model_.metric.lean;
  root_height_ = root_heights(problem_, f);
  const VectorXd rest = f - problem_.variables.T * root_height_;
  const VectorXd force = multiply_where_set(model_.metric.A, rest) + lean.pull;
  if (!has_soft_) follow(f);
  BoundQpSolution solution = solve_program(force, springs, context);

  Contact contact;
  contact.status = solution.report.status;
  contact.factorisations = solution.report.factorisations;
  if (has_soft_) {
    contact.soft = matrix_.direction.cwiseProduct(solution.z.tail(springs.pull.size()));
    const VectorXd g = T_ * solution.z - rest;
    contact.force = lambda * (model_.metric.A * g - lean.pull);
    contact.shift_energy = g.dot(contact.force) + lambda * lean.rest(g);
  } else {
    contact.force = lambda * forces_of_gaps(problem_.forest, solution.mu);
    contact.shift_energy =
        lambda * (2 * solution.report.energy + rest.dot(force) + lean.rest(-rest));
  }
  last_ = std::move(solution.z);
  last_gradient_ = std::move(solution.gradient);
  last_f_ = f;
  return contact;
}

void ContactStep::follow(const VectorXd& f) {
  const VectorXd change = f - last_f_;
  VectorXd shift = VectorXd::Zero(f.size());
  for (const DepthGap& gap : problem_.forest.gaps) {
    const double opening = change[gap.child] - change[gap.parent];
    shift[gap.child] = shift[gap.parent];
    if (gap.equal || system_.closed[gap.child] != 0)
      shift[gap.child] -= opening;
    else
      last_[gap.child] += gap.sign * opening;
  }
  last_gradient_ += T_.transpose() * multiply_where_set(model_.metric.A, shift);
}

BoundQpSolution ContactStep::solve_program(const VectorXd& force, const Springs& springs,
                                           const RunContext& context) {
  BoundQp& qp = system_.qp;
  qp.b = T_.transpose() * force;
  BoundQpOptions options;
  if (has_soft_) {
    qp.b.tail(springs.pull.size()) +=
        matrix_.direction.cwiseProduct(springs.pull) / model_.lambda_shift;
    set_springs(matrix_, springs.stiffness / model_.lambda_shift, qp.K);
  } else {
    options.same_matrix = system_.factorised;
    options.start_gradient = std::move(last_gradient_);
    options.refine = false;
  }
  options.start_active = std::move(system_.closed);
  options.tolerance = contact_tolerance;
  options.start = std::move(last_);
  BoundQpSolution solution = solve_bound_qp(qp, system_.factor, std::move(options), context);
  system_.factorised = solution.report.factorisations > 0;
  system_.closed = std::move(solution.active);
  return solution;
}

std::vector<double> ContactStep::heights() const {
  const double scale = model_.metric.scale;
  return heights_of(problem_, root_height_ / scale, last_, scale);
}

}  // namespace relievo

#include "relief/nonlinear/contact_step.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "kernel/cholesky/sparse_products.h"

namespace relievo::relief {

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

BoundQpSolution solve_program(DepthSystem& system, BoundQpOptions options,
                              const RunContext& context) {
  options.start_active = std::move(system.closed);
  options.tolerance = contact_tolerance;
  BoundQpSolution solution = solve_bound_qp(system.qp, system.factor, std::move(options), context);
  system.closed = std::move(solution.active);
  return solution;
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

ContactStep::ContactStep(const NonlinearModel& model, DepthSystem& order,
                         const std::vector<int>& soft)
    : model_(model), order_(order), problem_(order.problem), has_soft_(!soft.empty()) {
  if (has_soft_)
    soften(soft);
  else
    begin_flat();
}

/// The solution where f is 0 and all gaps are closed; nothing but leans pulls at it.
void ContactStep::begin_flat() {
  const SparseMatrix& T = problem_.variables.T;
  last_f_ = VectorXd::Zero(T.rows());
  last_ = VectorXd::Zero(T.cols());
  last_gradient_ = -(T.transpose() * model_.metric.lean.pull);
}

void ContactStep::soften(const std::vector<int>& soft) {
  matrix_ = make_soft_matrix(model_, problem_, soft);
  BoundQp& qp = own_.qp;
  qp.bounded = problem_.variables.bounded;
  qp.fixed = problem_.variables.fixed;
  own_.closed = order_.closed;
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
  if (has_soft_) return solve_softly(f, springs, context);
  return solve_firmly(f, context);
}

Contact ContactStep::solve_softly(const VectorXd& f, const Springs& springs,
                                  const RunContext& context) {
  const double lambda = model_.lambda_shift;
  const ShiftMetric& metric = model_.metric;
  const Eigen::Index softs = springs.pull.size();
  const VectorXd rest = beyond_roots(problem_, f);
  own_.qp.b = multiply_transposed(matrix_.T, metric.A * rest + metric.lean.pull);
  own_.qp.b.tail(softs) += matrix_.direction.cwiseProduct(springs.pull) / lambda;
  set_springs(matrix_, springs.stiffness / lambda, own_.qp.K);
  BoundQpOptions options;
  options.start = std::move(last_);
  const BoundQpSolution solution = solve_program(own_, std::move(options), context);

  Contact contact;
  contact.status = solution.report.status;
  contact.factorisations = solution.report.factorisations;
  contact.soft = matrix_.direction.cwiseProduct(solution.z.tail(softs));
  const VectorXd g = matrix_.T * solution.z - rest;
  contact.force = lambda * (metric.A * g - metric.lean.pull);
  contact.shift_energy = g.dot(contact.force) + lambda * metric.lean.rest(g);
  last_ = solution.z;
  last_f_ = f;
  return contact;
}

Contact ContactStep::solve_firmly(const VectorXd& f, const RunContext& context) {
  const double lambda = model_.lambda_shift;
  const LeanTerm& lean = model_.metric.lean;
  last_gradient_ = gradient_for(f);
  open_for(f);
  const VectorXd rest = beyond_roots(problem_, f);
  const VectorXd force = multiply_transposed(model_.metric.A, rest) + lean.pull;
  order_.qp.b = multiply_transposed(problem_.variables.T, force);
  BoundQpOptions options;
  options.start = std::move(last_);
  options.start_gradient = std::move(last_gradient_);
  options.refine = false;
  BoundQpSolution solution = solve_program(order_, std::move(options), context);

  Contact contact;
  contact.status = solution.report.status;
  contact.factorisations = solution.report.factorisations;
  contact.force = lambda * forces_of_gaps(problem_.forest, solution.mu);
  contact.shift_energy = lambda * (2 * solution.report.energy + rest.dot(force) + lean.rest(-rest));
  last_ = std::move(solution.z);
  last_gradient_ = std::move(solution.gradient);
  last_f_ = f;
  return contact;
}

/// The gradient where the gaps that are closed stay so and those that are open give way to f: what
/// is left to solve for is next to closed ones.
VectorXd ContactStep::gradient_for(const VectorXd& f) const {
  VectorXd shift = VectorXd::Zero(f.size());
  for (const DepthGap& gap : problem_.forest.gaps) {
    shift[gap.child] = shift[gap.parent];
    if (is_closed(gap)) shift[gap.child] -= rise_over_parent(gap, f);
  }
  const VectorXd force = multiply_where_set(model_.metric.A, shift);
  return last_gradient_ + multiply_transposed(problem_.variables.T, force);
}

/// Takes the last solution there.
void ContactStep::open_for(const VectorXd& f) {
  for (const DepthGap& gap : problem_.forest.gaps)
    if (!is_closed(gap)) last_[gap.child] += gap.sign * rise_over_parent(gap, f);
}

bool ContactStep::is_closed(const DepthGap& gap) const {
  return gap.equal || order_.closed[gap.child] != 0;
}

/// How much more f has risen at the child of a gap than at its parent.
double ContactStep::rise_over_parent(const DepthGap& gap, const VectorXd& f) const {
  return f[gap.child] - last_f_[gap.child] - (f[gap.parent] - last_f_[gap.parent]);
}

std::vector<double> ContactStep::heights() const {
  const double scale = model_.metric.scale;
  return heights_of(problem_, root_heights(problem_, last_f_) / scale, last_, scale);
}

}  // namespace relievo::relief

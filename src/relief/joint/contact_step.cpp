#include "relief/joint/contact_step.h"

#include <numeric>
#include <utility>

#include "kernel/solvers/sparse_products.h"

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

BoundQpSolution solve_program(DepthSystem& system, BoundQpOptions options,
                              const RunContext& context) {
  options.start_active = std::move(system.closed);
  options.tolerance = contact_tolerance;
  BoundQpSolution solution = solve_bound_qp(system.qp, system.factor, std::move(options), context);
  system.factorised = solution.report.factorisations > 0;
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

ContactStep::ContactStep(const JointModel& model, DepthSystem& order, const std::vector<int>& soft)
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
  std::vector<int> heights(model_.elimination.size());
  std::iota(heights.begin(), heights.end(), 0);
  matrix_ = make_soft_matrix(model_, problem_, heights, soft);
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
  Contact contact = has_soft_ ? solve_softly(f, springs, context) : solve_firmly(f, context);
  last_f_ = f;
  return contact;
}

Contact ContactStep::solve_softly(const VectorXd& f, const Springs& springs,
                                  const RunContext& context) {
  const double lambda = model_.lambda_shift;
  const ShiftMetric& metric = model_.metric;
  const Eigen::Index softs = springs.pull.size();
  const VectorXd rest = f - problem_.variables.T * root_heights(problem_, f);
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
  return contact;
}

Contact ContactStep::solve_firmly(const VectorXd& f, const RunContext& context) {
  const double lambda = model_.lambda_shift;
  const LeanTerm& lean = model_.metric.lean;
  const VectorXd rest = follow(f);
  const VectorXd force = multiply_transposed(model_.metric.A, rest) + lean.pull;
  order_.qp.b = multiply_transposed(problem_.variables.T, force);
  BoundQpOptions options;
  options.same_matrix = order_.factorised;
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
  return contact;
}

VectorXd ContactStep::follow(const VectorXd& f) {
  VectorXd root_height = f;
  VectorXd rest = VectorXd::Zero(f.size());
  VectorXd shift = VectorXd::Zero(f.size());
  for (const auto& [parent, child, sign, equal] : problem_.forest.gaps) {
    root_height[child] = root_height[parent];
    rest[child] = f[child] - root_height[parent];
    const double opening = f[child] - last_f_[child] - (f[parent] - last_f_[parent]);
    shift[child] = shift[parent];
    if (equal || order_.closed[child] != 0)
      shift[child] -= opening;
    else
      last_[child] += sign * opening;
  }
  last_gradient_ +=
      multiply_transposed(problem_.variables.T, multiply_where_set(model_.metric.A, shift));
  return rest;
}

std::vector<double> ContactStep::heights() const {
  const double scale = model_.metric.scale;
  return heights_of(problem_, root_heights(problem_, last_f_) / scale, last_, scale);
}

}  // namespace relievo

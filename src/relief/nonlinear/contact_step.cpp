// The contact step: the depth order [P eq 10-13] for the present f, in scene units,
//
//   minimise lambda_shift (1/2 g'A g - b'g) + sum over F of 1/2 k y^2 - p y,    h = f + g
//
// under the depth pairs, with f + y in place of f at the free nodes F. Its result is the force
//
//   q = lambda_shift (A g - b) = lambda_shift sum over gaps of mu (sign e_child - sign e_parent)
//
//   letter    in the code
//   A, b      ShiftMetric::A, b
//   F         `free`: nodes with depth pairs where u may have either sign
//   k, p      `stiffness`, `linear` (NonlinearMap::mixed_stiffness, mixed_linear_term)
//   q         Contact::force
//   mu        multipliers of the gaps (BoundQpSolution::mu)

#include "relief/nonlinear/contact_step.h"

#include <utility>

#include "kernel/cholesky/sparse_products.h"

namespace relievo::relief {

using Eigen::VectorXd;

namespace {

/// The final depth order is solved again, to round-off.
constexpr double contact_tolerance = 1e-11;

/// Returns A g - b from the multipliers mu of the gaps, #N. It is exactly 0 where no gap acts, so
/// that solves skip those nodes.
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

/// Computes A v at the cost of the columns where v is not 0.
VectorXd multiply_where_set(const SparseMatrix& A, const VectorXd& v) {
  VectorXd product = VectorXd::Zero(A.rows());
  for (int j = 0; j < A.outerSize(); ++j)
    if (v[j] != 0)
      for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
        product[entry.row()] += entry.value() * v[j];
  return product;
}

}  // namespace

ContactStep::ContactStep(const NonlinearModel& model, DepthSystem& depth,
                         const std::vector<int>& free)
    : model_(model), depth_(depth), has_free_(!free.empty()) {
  if (has_free_)
    make_free_program(free);
  else
    start_at_zero();
}

/// Sets the solution for f = 0 with all gaps closed, where only wanted shifts act.
void ContactStep::start_at_zero() {
  f_ = VectorXd::Zero(depth_.T.rows());
  z_ = VectorXd::Zero(depth_.T.cols());
  gradient_ = -(depth_.T.transpose() * model_.metric.b);
}

void ContactStep::make_free_program(const std::vector<int>& free) {
  matrix_ = make_shift_matrix(model_, depth_, free);
  BoundQp& qp = free_.qp;
  qp.bounded = depth_.qp.bounded;
  qp.fixed = depth_.qp.fixed;
  free_.closed = depth_.closed;
  const auto unknowns = static_cast<size_t>(matrix_.T.cols());
  for (std::vector<uint8_t>* flags : {&qp.bounded, &qp.fixed, &free_.closed})
    flags->resize(unknowns, 0);
  qp.K.swap(matrix_.K);
}

bool ContactStep::prepare(const RunContext& context) {
  if (!has_free_) return !context.cancelled();
  return free_.factor.analyse(free_.qp.K, Refactorisation::incremental, matrix_.elimination,
                              context);
}

Contact ContactStep::solve(const VectorXd& f, const VectorXd& stiffness, const VectorXd& linear,
                           const RunContext& context) {
  return has_free_ ? solve_free(f, stiffness, linear, context) : solve_fixed(f, context);
}

Contact ContactStep::solve_free(const VectorXd& f, const VectorXd& stiffness,
                                const VectorXd& linear, const RunContext& context) {
  const double lambda = model_.lambda_shift;
  const ShiftMetric& metric = model_.metric;
  const VectorXd d = beyond_roots(depth_, f);
  free_.qp.b = multiply_transposed(matrix_.T, metric.A * d + metric.b);
  free_.qp.b.tail(linear.size()) += matrix_.sign.cwiseProduct(linear) / lambda;
  set_stiffness(matrix_, stiffness / lambda, free_.qp.K);
  BoundQpOptions options;
  options.start = std::move(z_);
  const BoundQpSolution solution = solve_program(free_, std::move(options), context);

  Contact contact;
  contact.status = solution.report.status;
  contact.factorisations = solution.report.factorisations;
  contact.change = matrix_.sign.cwiseProduct(solution.z.tail(linear.size()));
  const VectorXd g = matrix_.T * solution.z - d;
  contact.force = lambda * (metric.A * g - metric.b);
  contact.shift_energy = g.dot(contact.force) + lambda * metric.rest(g);
  z_ = solution.z;
  f_ = f;
  return contact;
}

Contact ContactStep::solve_fixed(const VectorXd& f, const RunContext& context) {
  const double lambda = model_.lambda_shift;
  const ShiftMetric& metric = model_.metric;
  gradient_ = gradient_for(f);
  open_for(f);
  const VectorXd d = beyond_roots(depth_, f);
  const VectorXd force = multiply_transposed(metric.A, d) + metric.b;
  depth_.qp.b = multiply_transposed(depth_.T, force);
  BoundQpOptions options;
  options.start = std::move(z_);
  options.start_gradient = std::move(gradient_);
  options.refine = false;
  BoundQpSolution solution = solve_program(depth_, std::move(options), context);

  Contact contact;
  contact.status = solution.report.status;
  contact.factorisations = solution.report.factorisations;
  contact.force = lambda * forces_of_gaps(depth_.forest, solution.mu);
  contact.shift_energy = lambda * (2 * solution.report.energy + d.dot(force) + metric.rest(-d));
  z_ = std::move(solution.z);
  gradient_ = std::move(solution.gradient);
  f_ = f;
  return contact;
}

/// Returns the gradient K z - b for the new f at the last solution, moved so that closed gaps stay
/// closed and open gaps follow f. What is left to solve for lies next to closed gaps.
VectorXd ContactStep::gradient_for(const VectorXd& f) const {
  VectorXd shift = VectorXd::Zero(f.size());
  for (const DepthGap& gap : depth_.forest.gaps) {
    shift[gap.child] = shift[gap.parent];
    if (is_closed(gap)) shift[gap.child] -= rise_over_parent(gap, f);
  }
  const VectorXd force = multiply_where_set(model_.metric.A, shift);
  return gradient_ + multiply_transposed(depth_.T, force);
}

/// Moves the last solution so that open gaps follow f.
void ContactStep::open_for(const VectorXd& f) {
  for (const DepthGap& gap : depth_.forest.gaps)
    if (!is_closed(gap)) z_[gap.child] += gap.sign * rise_over_parent(gap, f);
}

bool ContactStep::is_closed(const DepthGap& gap) const {
  return gap.equal || depth_.closed[gap.child] != 0;
}

/// Returns the rise of f at the child of a gap minus that at its parent, since the last solution.
double ContactStep::rise_over_parent(const DepthGap& gap, const VectorXd& f) const {
  return f[gap.child] - f_[gap.child] - (f[gap.parent] - f_[gap.parent]);
}

std::vector<double> ContactStep::heights() const {
  const double scale = model_.metric.scale;
  return heights_of(depth_, root_heights(depth_.forest, f_) / scale, z_, scale);
}

}  // namespace relievo::relief

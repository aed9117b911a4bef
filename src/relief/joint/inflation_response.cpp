#include "relief/joint/inflation_response.h"

#include "relief/inflation/poisson_terms.h"

namespace relievo {

using Eigen::VectorXd;

InflationResponse::InflationResponse(const JointModel& model) : model_(model) {
  const SparseMatrix A = lower_block(model.L, model.place, static_cast<int>(model.inner.size()));
  factor_.analyse(A, Refactorisation::complete, order_of_places(model.elimination, model.place));
  sound_ = factor_.factorise(A);
}

VectorXd InflationResponse::solve_poisson(const VectorXd& load) const {
  VectorXd b(static_cast<Eigen::Index>(model_.inner.size()));
  for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = load[model_.inner[i]];
  const VectorXd x = factor_.solve(b);
  VectorXd solution = VectorXd::Zero(load.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) solution[model_.inner[i]] = x[i];
  return solution;
}

Excess InflationResponse::excess(const VectorXd& load) const {
  Excess excess;
  excess.s = solve_poisson(load);
  excess.energy = excess.s.dot(model_.mass.cwiseProduct(excess.s));
  const VectorXd gradient = model_.L * excess.s;
  excess.slope.resize(static_cast<Eigen::Index>(model_.bound.size()));
  for (Eigen::Index i = 0; i < excess.slope.size(); ++i)
    excess.slope[i] = gradient[model_.bound[i]];
  return excess;
}

VectorXd InflationResponse::with_bound(VectorXd u, const VectorXd& u_bound) const {
  for (Eigen::Index i = 0; i < u_bound.size(); ++i) u[model_.bound[i]] = u_bound[i];
  return u;
}

VectorXd InflationResponse::extension(const VectorXd& u_bound) const {
  const VectorXd known = with_bound(VectorXd::Zero(model_.held.size()), u_bound);
  return solve_poisson(-(model_.L * known)) + known;
}

VectorXd InflationResponse::inflate(const Excess& excess, const VectorXd& u_bound) const {
  const VectorXd known = with_bound(model_.held, u_bound);
  const VectorXd load = model_.load + model_.mass.cwiseProduct(excess.s) - model_.L * known;
  return solve_poisson(load) + known;
}

VectorXd InflationResponse::compliance(const VectorXd& load) const {
  return solve_poisson(model_.mass.cwiseProduct(solve_poisson(load)));
}

}  // namespace relievo

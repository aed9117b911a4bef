#include "relief/nonlinear/inflation_response.h"

#include "relief/inflation/poisson_terms.h"

namespace relievo {

using Eigen::VectorXd;

InflationResponse::InflationResponse(const NonlinearModel& model)
    : model_(model), own_load_(model.load - model.L * model.held) {
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
  excess.slope.resize(static_cast<Eigen::Index>(model_.bound.size()));
  for (Eigen::Index i = 0; i < excess.slope.size(); ++i)
    excess.slope[i] = model_.L.col(model_.bound[i]).dot(excess.s);
  return excess;
}

VectorXd InflationResponse::with_bound(VectorXd u, const VectorXd& u_bound) const {
  for (Eigen::Index i = 0; i < u_bound.size(); ++i) u[model_.bound[i]] = u_bound[i];
  return u;
}

/// load -= L u for a u on B alone.
void InflationResponse::subtract_bound(const VectorXd& u_bound, VectorXd& load) const {
  for (Eigen::Index i = 0; i < u_bound.size(); ++i)
    load -= u_bound[i] * model_.L.col(model_.bound[i]);
}

VectorXd InflationResponse::inflate(const Excess& excess, const VectorXd& u_bound) const {
  VectorXd load = own_load_ + model_.mass.cwiseProduct(excess.s);
  subtract_bound(u_bound, load);
  return with_bound(solve_poisson(load) + model_.held, u_bound);
}

VectorXd InflationResponse::compliance(const VectorXd& load) const {
  return solve_poisson(model_.mass.cwiseProduct(solve_poisson(load)));
}

}  // namespace relievo

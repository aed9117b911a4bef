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

Inflated InflationResponse::solve(const VectorXd& load, const VectorXd& u_bound) const {
  const VectorXd excess = solve_poisson(load);
  const VectorXd weighted = model_.mass.cwiseProduct(excess);
  VectorXd known = model_.held;
  for (Eigen::Index i = 0; i < u_bound.size(); ++i) known[model_.bound[i]] = u_bound[i];
  Inflated inflated;
  inflated.u = solve_poisson(model_.load + weighted - model_.L * known) + known;
  const VectorXd gradient = model_.L * excess;
  inflated.slope.resize(u_bound.size());
  for (Eigen::Index i = 0; i < u_bound.size(); ++i) inflated.slope[i] = gradient[model_.bound[i]];
  inflated.energy = excess.dot(weighted);
  return inflated;
}

VectorXd InflationResponse::compliance(const VectorXd& load) const {
  return solve_poisson(model_.mass.cwiseProduct(solve_poisson(load)));
}

}  // namespace relievo

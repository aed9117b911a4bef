#include "relief/nonlinear/nonlinear_model.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "relief/inflation/poisson_system.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

/// #N: whether the node may be on B: a pair ties it to another part, or may lift f there.
std::vector<uint8_t> lifted_nodes(const LayeredMesh& mesh, const std::vector<int>& sign) {
  std::vector<uint8_t> lifted(mesh.node_role.size(), 0);
  for (const DepthPair& pair : mesh.constraints) {
    if (pair.equal || sign[pair.upper] >= 0) lifted[pair.upper] = 1;
    if (pair.equal || sign[pair.lower] < 0) lifted[pair.lower] = 1;
  }
  return lifted;
}

/// B with the outline that its nodes stand for; a node under two ranges counts once for each.
void collect_bound(const LayeredMesh& mesh, NonlinearModel& model) {
  const std::vector<uint8_t> lifted = lifted_nodes(mesh, model.sign);
  for (const RampNode& node : mesh.ramp_nodes)
    if (lifted[node.node] != 0) model.bound.push_back(node.node);
  std::sort(model.bound.begin(), model.bound.end());
  model.bound.erase(std::unique(model.bound.begin(), model.bound.end()), model.bound.end());
  model.bound_mass = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.bound.size()));
  model.bound_ramp.assign(model.bound.size(), -1);
  for (const RampNode& node : mesh.ramp_nodes) {
    if (lifted[node.node] == 0) continue;
    const auto at = std::lower_bound(model.bound.begin(), model.bound.end(), node.node);
    model.bound_mass[at - model.bound.begin()] += model.metric.scale * node.mass;
    model.bound_ramp[at - model.bound.begin()] = node.ramp;
  }
  model.loose_gap.assign(model.bound.size(), -1);
}

/// #N: whether the node is seen from the front or in a pair.
std::vector<uint8_t> shown_nodes(const LayeredMesh& mesh) {
  std::vector<uint8_t> shown = seen_nodes(mesh);
  for (const DepthPair& pair : mesh.constraints) shown[pair.lower] = shown[pair.upper] = 1;
  return shown;
}

/// The other nodes under ranges stay as the start has them, but for those that are seen: there
/// lambda_bnd pulls, and nothing against it.
void hold_rest_of_ranges(const LayeredMesh& mesh, const Inflation& start, NonlinearModel& model) {
  const double area = model.metric.scale * model.metric.scale;
  const std::vector<uint8_t> shown = shown_nodes(mesh);
  model.held = Eigen::VectorXd::Zero(model.load.size());
  for (const RampNode& node : mesh.ramp_nodes)
    if (shown[node.node] == 0) model.held[node.node] = area * start.u[node.node];
  for (const int n : model.bound) model.held[n] = 0;
}

void number_inner(NonlinearModel& model) {
  model.place.assign(static_cast<size_t>(model.load.size()), -1);
  for (size_t i = 0; i < model.inner.size(); ++i) model.place[model.inner[i]] = static_cast<int>(i);
}

}  // namespace

NonlinearModel make_joint_model(const OrderingInput& input, const ShiftMetric& metric) {
  const LayeredMesh& mesh = input.mesh;
  const Discretisation& discretisation = input.discretisation;
  NonlinearModel model;
  model.metric = metric;
  model.L = discretisation.L;
  model.mass = discretisation.mass;
  model.elimination = discretisation.elimination;
  InflationTerms terms = inflation_terms(mesh, input.scene, model.metric.scale);
  model.load = std::move(terms.load);
  model.L.diagonal() += terms.screening;
  model.sign = surface_signs(mesh, discretisation.surface, input.scene);
  collect_bound(mesh, model);
  hold_rest_of_ranges(mesh, input.inflation, model);
  for (size_t n = 0; n < mesh.node_role.size(); ++n) {
    const bool bound = mesh.node_role[n] == NodeRole::ramp;
    const bool takes_part = model.mass[static_cast<Eigen::Index>(n)] > 0;
    if (takes_part && !bound && mesh.node_role[n] != NodeRole::outline && input.inflation.u[n] != 0)
      model.inner.push_back(static_cast<int>(n));
  }
  number_inner(model);
  return model;
}

/// A node that is tied is not loose, whatever else it touches.
void find_loose_bound(const DepthForest& forest, NonlinearModel& model) {
  std::vector<int> lifted(model.place.size(), -1);
  for (const DepthGap& gap : forest.gaps) {
    const auto [lower, upper] =
        gap.sign > 0 ? std::pair(gap.parent, gap.child) : std::pair(gap.child, gap.parent);
    if (model.sign[upper] >= 0 && lifted[upper] < 0) lifted[upper] = gap.child;
    if (model.sign[lower] < 0 && lifted[lower] < 0) lifted[lower] = gap.child;
  }
  for (const DepthGap& gap : forest.gaps)
    if (gap.equal) lifted[gap.parent] = lifted[gap.child] = -1;
  for (size_t i = 0; i < model.bound.size(); ++i) model.loose_gap[i] = lifted[model.bound[i]];
}

bool is_mixed(const NonlinearModel& model) {
  return std::count(model.sign.begin(), model.sign.end(), 0) > 0;
}

bool hold_wrong_signs(const Eigen::VectorXd& u, NonlinearModel& model) {
  const size_t before = model.inner.size();
  const auto wrong = [&](int n) { return model.sign[n] * u[n] < 0; };
  model.inner.erase(std::remove_if(model.inner.begin(), model.inner.end(), wrong),
                    model.inner.end());
  number_inner(model);
  return model.inner.size() < before;
}

NonlinearEnergy nonlinear_energy(const NonlinearModel& model, const Eigen::VectorXd& u,
                                 const Eigen::VectorXd& g) {
  NonlinearEnergy energy;
  const Eigen::VectorXd excess = model.L * u - model.load;
  for (const int n : model.inner) energy.inflation += excess[n] * excess[n] / model.mass[n];
  for (size_t i = 0; i < model.bound.size(); ++i)
    energy.boundary += model.lambda_bnd * model.bound_mass[static_cast<Eigen::Index>(i)] *
                       std::abs(u[model.bound[i]]);
  const LeanTerm& lean = model.metric.lean;
  energy.shift = model.lambda_shift * (g.dot(model.metric.A * g - lean.pull) + lean.rest(g));
  return energy;
}

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

}  // namespace relievo::relief

#include "relief/joint/joint_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// |f| is taken at least so large where B should leave 0.
constexpr double smallest_f = 1e-3;
/// |u| is taken at least so large for the resistance of a soft node.
constexpr double smallest_u = 1e-3;
/// A spring on B is kept at least so stiff, relative to lambda_bnd alone.
constexpr double softest = 0.2;
/// A typical resistance of the contact against f on B.
constexpr double contact_stiffness = 0.3;

/// One flag per variable: whether it is that of a pair.
std::vector<uint8_t> pressed_variables(const DepthProblem& problem) {
  const std::vector<int>& variable = problem.variables.variable;
  std::vector<uint8_t> pressed(problem.variables.bounded.size(), 0);
  for (size_t n = 0; n < variable.size(); ++n)
    if (problem.forest.representative[n] != static_cast<int>(n)) pressed[variable[n]] = 1;
  for (const DepthGap& gap : problem.forest.gaps)
    pressed[variable[gap.parent]] = pressed[variable[gap.child]] = 1;
  return pressed;
}

/// The inner nodes that are in pairs, or those that are not.
std::vector<int> inner_nodes(const JointModel& model, const DepthProblem& problem, bool in_pairs) {
  const std::vector<uint8_t> pressed = pressed_variables(problem);
  std::vector<int> nodes;
  for (const int n : model.inner)
    if ((pressed[problem.variables.variable[n]] != 0) == in_pairs) nodes.push_back(n);
  return nodes;
}

std::vector<SoftNode> soft_nodes(const JointModel& model, const std::vector<int>& contact,
                                 bool all) {
  std::vector<SoftNode> soft;
  for (const int n : model.bound) soft.push_back({n, model.sign[n]});
  for (const int n : contact)
    if (all || model.sign[n] == 0) soft.push_back({n, 0});
  return soft;
}

}  // namespace

JointMap::JointMap(const JointModel& model, const InflationResponse& response,
                   const DepthProblem& problem, const Softness& softness,
                   const std::vector<double>& last_h)
    : model_(model),
      response_(response),
      smooth_root_(softness.width),
      nodes_(inner_nodes(model, problem, true)),
      apart_(inner_nodes(model, problem, false)),
      soft_(soft_nodes(model, nodes_, softness.all)),
      contact_step_(model, problem, soft_, last_h),
      bounds_(model.bound_mass.size()),
      stiffness_((model.lambda_bnd * model.bound_mass).array() + contact_stiffness),
      compliance_(compliance_of_soft_nodes(softness.share)) {}

VectorXd JointMap::pack(const JointState& state) const {
  const auto contacts = static_cast<Index>(nodes_.size());
  VectorXd x(contacts + 2 * bounds_ + compliance_.size());
  for (Index i = 0; i < contacts; ++i) {
    const double u = state.u[nodes_[i]];
    x[i] = model_.sign[nodes_[i]] * u < 0 ? 0 : u;
  }
  for (Index i = 0; i < bounds_; ++i) {
    x[contacts + i] = signed_root(state.u[model_.bound[i]]);
    x[contacts + bounds_ + i] = state.slope[i] / stiffness_[i];
  }
  for (Index i = 0; i < compliance_.size(); ++i)
    x[contacts + 2 * bounds_ + i] = state.load[soft_[bounds_ + i].node] * compliance_[i];
  return x;
}

void JointMap::unpack(const VectorXd& x, JointState& state) const {
  const auto contacts = static_cast<Index>(nodes_.size());
  for (Index i = 0; i < contacts; ++i) {
    const int n = nodes_[i];
    const int sign = model_.sign[n];
    const double least = sign * state.u[n] > 0 ? 0.1 * state.u[n] : 0;
    state.u[n] = sign != 0 && sign * x[i] < sign * least ? least : x[i];
  }
  for (Index i = 0; i < bounds_; ++i) {
    const double f = soft_[i].sign * x[contacts + i] < 0 ? 0 : x[contacts + i];
    state.u[model_.bound[i]] = f * std::abs(f);
    state.slope[i] = x[contacts + bounds_ + i] * stiffness_[i];
  }
  for (Index i = 0; i < compliance_.size(); ++i)
    state.load[soft_[bounds_ + i].node] = x[contacts + 2 * bounds_ + i] / compliance_[i];
}

SolveStatus JointMap::apply(JointState& state, JointStep& step, const RunContext& context) {
  VectorXd f = model_.held.unaryExpr(&signed_root);
  for (const int n : nodes_) f[n] = root(n).f(state.u[n]);
  Contact contact = contact_step_.solve(f, springs(state), context);
  if (contact.status != SolveStatus::solved) return contact.status;
  const VectorXd f_bound = contact.soft.head(bounds_);
  state.load = next_load(f, state, contact);
  const Inflated inflated = response_.solve(state.load, f_bound.cwiseProduct(f_bound.cwiseAbs()));
  state.u = inflated.u;
  state.slope = inflated.slope;
  state.h = std::move(contact.h);
  add_inflation(state);
  step.factorisations = contact.factorisations;
  step.energy.inflation = inflated.energy;
  step.energy.boundary = model_.lambda_bnd * model_.bound_mass.dot(f_bound.cwiseAbs2());
  step.energy.shift = contact.shift_energy;
  return SolveStatus::solved;
}

/// The contact knows no inflation where parts do not press.
void JointMap::add_inflation(JointState& state) const {
  for (const int n : apart_) state.h[n] += signed_root(state.u[n]) / model_.metric.scale;
}

Springs JointMap::springs(const JointState& state) const {
  Springs springs{VectorXd(soft_.size()), VectorXd::Zero(soft_.size())};
  for (Index i = 0; i < bounds_; ++i) bound_spring(state, i, springs);
  for (Index i = bounds_; i < springs.pull.size(); ++i) mixed_spring(state, i, springs);
  return springs;
}

/// The inflation's resistance to f on B as a spring with the right force at the present f; where
/// it would be too soft, a stiffer one that pulls towards it.
void JointMap::bound_spring(const JointState& state, Index i, Springs& springs) const {
  const double f = signed_root(state.u[model_.bound[i]]);
  const bool sunk = f < 0 || (f == 0 && soft_[i].sign < 0);
  const double own = model_.lambda_bnd * model_.bound_mass[i];
  const double resistance = own + 2 * (sunk ? -state.slope[i] : state.slope[i]);
  springs.stiffness[i] = resistance;
  if (resistance >= softest * own) return;
  springs.stiffness[i] = own + 2 * std::abs(state.slope[i]);
  const double size = resistance < 0 ? std::max(std::abs(f), smallest_f) : std::abs(f);
  springs.pull[i] = (springs.stiffness[i] - resistance) * (sunk ? -size : size);
}

/// The same for a change of f at a soft node: the inflation holds it with the load times du/df,
/// and the load grows with u as the compliance says.
void JointMap::mixed_spring(const JointState& state, Index i, Springs& springs) const {
  const int n = soft_[i].node;
  const double u = state.u[n];
  const double step = 1 / root(n).slope(u);
  const double growth = std::max(step * step, 4 * smallest_u) / compliance_[i - bounds_];
  const double own = 2 * (u < 0 ? -state.load[n] : state.load[n]);
  springs.stiffness[i] = std::max(growth + own, 0.5 * growth);
  springs.pull[i] = -step * state.load[n];
}

/// A force on f is a load on u by the slope of the root; at soft nodes, whose f may pass 0, the
/// load follows the change of u instead.
VectorXd JointMap::next_load(const VectorXd& f, const JointState& state,
                             const Contact& contact) const {
  VectorXd load = VectorXd::Zero(f.size());
  for (const int n : nodes_) load[n] = contact.force[n] * root(n).slope(state.u[n]);
  for (Index i = 0; i < compliance_.size(); ++i) {
    const int n = soft_[bounds_ + i].node;
    const double next = root(n).u(f[n] + contact.soft[bounds_ + i]);
    load[n] = state.load[n] + (next - state.u[n]) / compliance_[i];
  }
  return load;
}

/// How far u gives way at each of them when all are loaded alike.
VectorXd JointMap::compliance_of_soft_nodes(double share) const {
  const Index count = static_cast<Index>(soft_.size()) - bounds_;
  VectorXd compliance(count);
  if (count == 0) return compliance;
  VectorXd load = VectorXd::Zero(model_.load.size());
  for (Index i = 0; i < count; ++i) load[soft_[bounds_ + i].node] = 1;
  const VectorXd u = response_.compliance(load);
  for (Index i = 0; i < count; ++i)
    compliance[i] = share * std::max(1e-12, u[soft_[bounds_ + i].node]);
  return compliance;
}

}  // namespace relievo

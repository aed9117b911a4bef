#include "relief/nonlinear/nonlinear_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// |u| is taken at least so large for the resistance of a soft node.
constexpr double smallest_u = 1e-3;
/// A spring on B is kept at least so stiff, relative to lambda_bnd alone.
constexpr double softest = 0.2;
/// Of the largest force, for a gap that would have to pull.
constexpr double least_pull = 1e-6;
/// Of the largest f, for gaps on B.
constexpr double widest_gap = 4;

/// #N: whether the node is in a pair.
std::vector<uint8_t> pressed_nodes(const DepthProblem& problem) {
  std::vector<uint8_t> pressed(problem.forest.group.size(), 0);
  for (const DepthGap& gap : problem.forest.gaps) pressed[gap.parent] = pressed[gap.child] = 1;
  return pressed;
}

/// The inner nodes that are in pairs, or those that are not.
std::vector<int> inner_nodes(const NonlinearModel& model, const DepthProblem& problem,
                             bool in_pairs) {
  const std::vector<uint8_t> pressed = pressed_nodes(problem);
  std::vector<int> nodes;
  for (const int n : model.inner)
    if ((pressed[n] != 0) == in_pairs) nodes.push_back(n);
  return nodes;
}

/// Those where u may have either sign.
std::vector<int> soft_nodes(const NonlinearModel& model, std::vector<int> contact) {
  const auto firm = [&](int n) { return model.sign[n] != 0; };
  contact.erase(std::remove_if(contact.begin(), contact.end(), firm), contact.end());
  return contact;
}

}  // namespace

NonlinearMap::NonlinearMap(const NonlinearSystems& systems, const Softness& softness)
    : model_(systems.inflation.model()),
      response_(systems.inflation),
      smooth_root_(softness.width),
      nodes_(inner_nodes(model_, systems.order.problem, true)),
      apart_(inner_nodes(model_, systems.order.problem, false)),
      soft_(soft_nodes(model_, nodes_)),
      held_f_(model_.held.unaryExpr(&signed_root)),
      contact_step_(model_, systems.order, soft_),
      gap_columns_(systems.order.problem.variables.T),
      bound_step_(systems.bound),
      bounds_(model_.bound_mass.size()),
      compliance_(compliance_of_soft_nodes(softness.share)) {
  bound_step_.resist(softness.bound);
}

VectorXd NonlinearMap::pack(const NonlinearState& state) const {
  const auto contacts = static_cast<Index>(nodes_.size());
  VectorXd x(contacts + bounds_ + compliance_.size());
  for (Index i = 0; i < contacts; ++i) {
    const double u = state.u[nodes_[i]];
    x[i] = model_.sign[nodes_[i]] * u < 0 ? 0 : u;
  }
  x.segment(contacts, bounds_) = f_on_bound(state);
  for (Index i = 0; i < compliance_.size(); ++i)
    x[contacts + bounds_ + i] = state.load[soft_[i]] * compliance_[i];
  return x;
}

void NonlinearMap::unpack(const VectorXd& x, NonlinearState& state) const {
  const auto contacts = static_cast<Index>(nodes_.size());
  for (Index i = 0; i < contacts; ++i) {
    const int n = nodes_[i];
    const int sign = model_.sign[n];
    if (sign == 0 || sign * x[i] >= std::max(0.0, 0.1 * sign * state.u[n])) state.u[n] = x[i];
  }
  for (Index i = 0; i < bounds_; ++i) {
    const int n = model_.bound[i];
    const double f = x[contacts + i];
    const bool sunk = model_.sign[n] * f < 0 && model_.loose_gap[i] < 0;
    state.u[n] = sunk ? 0 : f * std::abs(f);
  }
  for (Index i = 0; i < compliance_.size(); ++i)
    state.load[soft_[i]] = x[contacts + bounds_ + i] / compliance_[i];
}

SolveStatus NonlinearMap::apply(NonlinearState& state, NonlinearStep& step,
                                const RunContext& context) {
  const VectorXd f = fixed_f(state);
  const Contact contact = contact_step_.solve(f, springs(state), context);
  if (contact.status != SolveStatus::solved) return contact.status;
  state.load = next_load(f, state, contact);
  const Excess excess = response_.excess(state.load);
  VectorXd f_bound = f_on_bound(state);
  pulled_ = pulled_gaps(f_bound, contact);
  const SolveStatus moved = bound_step_.move(slope_on_bound(f_bound, contact, excess),
                                             springs_on_bound(f_bound, excess), context, f_bound);
  if (moved != SolveStatus::solved) return moved;
  keep_loose_within_reach(state, f_bound);
  const VectorXd u_bound = squares_on_bound(f_bound);
  state.u = response_.inflate(excess, u_bound);
  set_loose(f_bound, state);
  step.factorisations = contact.factorisations;
  step.energy.inflation = excess.energy;
  step.energy.boundary = model_.lambda_bnd * model_.bound_mass.dot(u_bound.cwiseAbs());
  step.energy.shift = contact.shift_energy;
  return SolveStatus::solved;
}

VectorXd NonlinearMap::f_on_bound(const NonlinearState& state) const {
  VectorXd f(bounds_);
  for (Index i = 0; i < bounds_; ++i) f[i] = signed_root(state.u[model_.bound[i]]);
  return f;
}

bool NonlinearMap::is_open(Index i, double f) const {
  return model_.loose_gap[i] >= 0 && f * (model_.sign[model_.bound[i]] < 0 ? -1 : 1) < 0;
}

/// Those that are closed and would have to pull.
std::vector<int> NonlinearMap::pulled_gaps(const VectorXd& f, const Contact& contact) const {
  const double tolerance = least_pull * contact.force.lpNorm<Eigen::Infinity>();
  std::vector<int> gaps;
  for (Index i = 0; i < bounds_; ++i) {
    const int gap = model_.loose_gap[i];
    if (gap >= 0 && !is_open(i, f[i]) && gap_columns_.col(gap).dot(contact.force) < -tolerance)
      gaps.push_back(gap);
  }
  return gaps;
}

/// A part that is free to move as a whole hardly resists, until it meets another.
void NonlinearMap::keep_loose_within_reach(const NonlinearState& state, VectorXd& f_bound) const {
  double largest = 0;
  for (const int n : model_.inner) largest = std::max(largest, std::abs(state.u[n]));
  const double reach = widest_gap * std::sqrt(largest);
  for (Index i = 0; i < bounds_; ++i)
    if (model_.loose_gap[i] >= 0) f_bound[i] = std::clamp(f_bound[i], -reach, reach);
}

/// u there; 0 where the gap is open.
VectorXd NonlinearMap::squares_on_bound(const VectorXd& f) const {
  VectorXd u = f.cwiseProduct(f.cwiseAbs());
  for (Index i = 0; i < bounds_; ++i)
    if (is_open(i, f[i])) u[i] = 0;
  return u;
}

/// On loose B, where the gap is not in the inflation.
void NonlinearMap::set_loose(const VectorXd& f, NonlinearState& state) const {
  for (Index i = 0; i < bounds_; ++i)
    if (model_.loose_gap[i] >= 0) state.u[model_.bound[i]] = f[i] * std::abs(f[i]);
}

/// #N: by how much the gaps that are open there move the heights.
VectorXd NonlinearMap::opening(const VectorXd& f_bound) const {
  VectorXd rise = VectorXd::Zero(model_.held.size());
  for (Index i = 0; i < bounds_; ++i)
    if (is_open(i, f_bound[i]))
      rise += std::abs(f_bound[i]) * gap_columns_.col(model_.loose_gap[i]);
  return rise;
}

VectorXd NonlinearMap::fixed_f(const NonlinearState& state) const {
  VectorXd f = held_f_;
  for (const int n : nodes_) f[n] = root(n).f(state.u[n]);
  const VectorXd f_bound = f_on_bound(state);
  for (Index i = 0; i < bounds_; ++i) f[model_.bound[i]] = is_open(i, f_bound[i]) ? 0 : f_bound[i];
  return f - opening(f_bound);
}

/// The slope of the energy / 2 with respect to f on B: its own, that of the inflation, and the
/// force of the contact against it.
VectorXd NonlinearMap::slope_on_bound(const VectorXd& f, const Contact& contact,
                                      const Excess& excess) const {
  VectorXd slope(bounds_);
  for (Index i = 0; i < bounds_; ++i) {
    if (is_open(i, f[i])) {
      const double widening = gap_columns_.col(model_.loose_gap[i]).dot(contact.force);
      slope[i] = model_.sign[model_.bound[i]] < 0 ? widening : -widening;
      continue;
    }
    const double own = model_.lambda_bnd * model_.bound_mass[i];
    slope[i] = own * f[i] + 2 * std::abs(f[i]) * excess.slope[i] - contact.force[model_.bound[i]];
  }
  return slope;
}

/// They stand for the curvature of the first two; where that would be too soft or negative, for
/// stiffer ones.
VectorXd NonlinearMap::springs_on_bound(const VectorXd& f, const Excess& excess) const {
  VectorXd springs(bounds_);
  for (Index i = 0; i < bounds_; ++i) {
    const int n = model_.bound[i];
    const double slope = excess.slope[i];
    const double own = model_.lambda_bnd * model_.bound_mass[i];
    const bool sunk = is_open(i, f[i]) ? f[i] > 0 : f[i] < 0 || (f[i] == 0 && model_.sign[n] < 0);
    const double resistance = own + 2 * (sunk ? -slope : slope);
    springs[i] = resistance >= softest * own ? resistance : own + 2 * std::abs(slope);
  }
  return springs;
}

/// The contact knows no inflation where parts do not press.
void NonlinearMap::find_heights(NonlinearState& state) const {
  state.h = contact_step_.heights();
  const VectorXd rise = opening(f_on_bound(state)) / model_.metric.scale;
  for (Index n = 0; n < rise.size(); ++n) state.h[n] += rise[n];
  for (const int n : apart_) state.h[n] += signed_root(state.u[n]) / model_.metric.scale;
}

/// For a change of f at a soft node: the inflation holds it with the load times du/df, and the
/// load grows with u as the compliance says.
Springs NonlinearMap::springs(const NonlinearState& state) const {
  Springs springs{VectorXd(compliance_.size()), VectorXd(compliance_.size())};
  for (Index i = 0; i < compliance_.size(); ++i) {
    const int n = soft_[i];
    const double u = state.u[n];
    const double step = 1 / root(n).slope(u);
    const double growth = std::max(step * step, 4 * smallest_u) / compliance_[i];
    const double own = 2 * (u < 0 ? -state.load[n] : state.load[n]);
    springs.stiffness[i] = std::max(growth + own, 0.5 * growth);
    springs.pull[i] = -step * state.load[n];
  }
  return springs;
}

/// A force on f is a load on u by the slope of the root; at soft nodes, whose f may pass 0, the
/// load follows the change of u instead.
VectorXd NonlinearMap::next_load(const VectorXd& f, const NonlinearState& state,
                                 const Contact& contact) const {
  VectorXd load = VectorXd::Zero(f.size());
  for (const int n : nodes_) load[n] = contact.force[n] * root(n).slope(state.u[n]);
  for (Index i = 0; i < compliance_.size(); ++i) {
    const int n = soft_[i];
    const double next = root(n).u(f[n] + contact.soft[i]);
    load[n] = state.load[n] + (next - state.u[n]) / compliance_[i];
  }
  return load;
}

/// How far u gives way at each of them when all are loaded alike.
VectorXd NonlinearMap::compliance_of_soft_nodes(double share) const {
  const auto count = static_cast<Index>(soft_.size());
  VectorXd compliance(count);
  if (count == 0) return compliance;
  VectorXd load = VectorXd::Zero(model_.load.size());
  for (Index i = 0; i < count; ++i) load[soft_[i]] = 1;
  const VectorXd u = response_.compliance(load);
  for (Index i = 0; i < count; ++i) compliance[i] = share * std::max(1e-12, u[soft_[i]]);
  return compliance;
}

}  // namespace relievo::relief

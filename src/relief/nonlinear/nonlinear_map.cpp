// One step of the non-linear method [P eq 3-6], in scene units. Its fixed points satisfy, with the
// forces q of the depth pairs and half the slope of the energy,
//
//   on I:    L_II s = phi,    phi = q df/du                            df/du = 1 / (2|f|)
//   on B:    e = lambda_bnd m f + 2|f| L_BI s - q = 0
//   or, where a gap on B is open:  f = 0,  e = -+ T_gap . q = 0        T_gap: column of T
//
// Steps: q from the contact for the present f (ContactStep); phi; s from L_II s = phi; y = f on B
// by the stiffness S + diag(sigma) (BoundaryStep); u from s and u_B.
//
// At mixed nodes, where u may have either sign, df/du would be infinite at u = 0. There f is
// unknown in the contact, with the inflation's resistance to a change y of f linearised,
//
//   1/2 k y^2 - p y,    k = (du/df)^2 / C + 2 sgn(u) phi,    p = -phi du/df
//   phi <- phi + (u(f + y) - u) / C
//
//   letter          in the code
//   I, B, m         NonlinearModel::inner, bound, bound_mass
//   f, df/du        SmoothRoot
//   q               Contact::force
//   phi             NonlinearState::load, next_load
//   s, L_BI s       InflationResponse::excess, boundary_slope
//   e, sigma        gradient_on_boundary, sigma_on_boundary
//   C               compliance_
//   k, p            mixed_stiffness, mixed_linear_term

#include "relief/nonlinear/nonlinear_map.h"

#include <algorithm>
#include <cmath>

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Least |u| in the stiffness k of a mixed node.
constexpr double smallest_u = 1e-3;
/// Least sigma, relative to lambda_bnd m.
constexpr double least_sigma = 0.2;
/// A gap pulls if its multiplier is below minus this share of the largest force.
constexpr double least_pull = 1e-6;
/// Largest gap on B, relative to the largest f.
constexpr double widest_gap = 4;

/// Returns the inner nodes that are in depth pairs, or those that are not.
std::vector<int> inner_nodes(const NonlinearModel& model, const DepthForest& forest,
                             bool in_pairs) {
  std::vector<bool> is_paired(forest.group.size(), false);
  for (const DepthGap& gap : forest.gaps) is_paired[gap.parent] = is_paired[gap.child] = true;
  std::vector<int> nodes;
  for (const int n : model.inner)
    if (is_paired[n] == in_pairs) nodes.push_back(n);
  return nodes;
}

/// Returns the nodes where u may have either sign.
std::vector<int> mixed_of(const NonlinearModel& model, std::vector<int> nodes) {
  const auto has_sign = [&](int n) { return model.sign[n] != 0; };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), has_sign), nodes.end());
  return nodes;
}

}  // namespace

NonlinearMap::NonlinearMap(const InflationResponse& response, DepthSystem& depth,
                           BoundaryStep& bound, const StepControl& control)
    : model_(response.model()),
      response_(response),
      smooth_root_(control.width),
      contact_nodes_(inner_nodes(model_, depth.forest, true)),
      other_nodes_(inner_nodes(model_, depth.forest, false)),
      mixed_nodes_(mixed_of(model_, contact_nodes_)),
      fixed_f_(model_.fixed_u.unaryExpr(&signed_root)),
      contact_step_(model_, depth, mixed_nodes_),
      T_(depth.T),
      bound_step_(bound),
      bound_count_(model_.bound_mass.size()),
      compliance_(mixed_compliance(control.compliance)) {
  bound_step_.add_stiffness(control.stiffness);
}

VectorXd NonlinearMap::pack(const NonlinearState& state) const {
  const auto contacts = static_cast<Index>(contact_nodes_.size());
  VectorXd x(contacts + bound_count_ + compliance_.size());
  for (Index i = 0; i < contacts; ++i) {
    const double u = state.u[contact_nodes_[i]];
    x[i] = model_.sign[contact_nodes_[i]] * u < 0 ? 0 : u;
  }
  x.segment(contacts, bound_count_) = y_on_boundary(state);
  for (Index i = 0; i < compliance_.size(); ++i)
    x[contacts + bound_count_ + i] = state.load[mixed_nodes_[i]] * compliance_[i];
  return x;
}

void NonlinearMap::unpack(const VectorXd& x, NonlinearState& state) const {
  const auto contacts = static_cast<Index>(contact_nodes_.size());
  for (Index i = 0; i < contacts; ++i) {
    const int n = contact_nodes_[i];
    const int sign = model_.sign[n];
    if (sign == 0 || sign * x[i] >= std::max(0.0, 0.1 * sign * state.u[n])) state.u[n] = x[i];
  }
  for (Index i = 0; i < bound_count_; ++i) {
    const int n = model_.bound[i];
    const double y = x[contacts + i];
    const bool wrong_sign = model_.sign[n] * y < 0 && model_.lifting_gap[i] < 0;
    state.u[n] = wrong_sign ? 0 : y * std::abs(y);
  }
  for (Index i = 0; i < compliance_.size(); ++i)
    state.load[mixed_nodes_[i]] = x[contacts + bound_count_ + i] / compliance_[i];
}

SolveStatus NonlinearMap::apply(NonlinearState& state, NonlinearStep& step,
                                const RunContext& context) {
  const VectorXd f = known_f(state);
  const Contact contact =
      contact_step_.solve(f, mixed_stiffness(state), mixed_linear_term(state), context);
  if (contact.status != SolveStatus::solved) return contact.status;
  state.load = next_load(f, state, contact);
  const VectorXd s = response_.excess(state.load);
  const VectorXd boundary_slope = response_.boundary_slope(s);
  VectorXd y = y_on_boundary(state);
  pulling_ = pulling_gaps(y, contact);
  const SolveStatus moved = bound_step_.move(gradient_on_boundary(y, contact, boundary_slope),
                                             sigma_on_boundary(y, boundary_slope), context, y);
  if (moved != SolveStatus::solved) return moved;
  limit_gaps(state, y);
  const VectorXd u_bound = u_on_boundary(y);
  state.u = response_.inflate(s, u_bound);
  keep_gaps(y, state);
  step.factorisations = contact.factorisations;
  step.energy.inflation = response_.energy(s);
  step.energy.boundary = model_.lambda_bnd * model_.bound_mass.dot(u_bound.cwiseAbs());
  step.energy.shift = contact.shift_energy;
  return SolveStatus::solved;
}

VectorXd NonlinearMap::y_on_boundary(const NonlinearState& state) const {
  VectorXd y(bound_count_);
  for (Index i = 0; i < bound_count_; ++i) y[i] = signed_root(state.u[model_.bound[i]]);
  return y;
}

/// Checks whether y says that the gap at node i of B is open.
bool NonlinearMap::is_open(Index i, double y) const {
  return model_.lifting_gap[i] >= 0 && y * (model_.sign[model_.bound[i]] < 0 ? -1 : 1) < 0;
}

std::vector<int> NonlinearMap::pulling_gaps(const VectorXd& y, const Contact& contact) const {
  const double tolerance = least_pull * contact.force.lpNorm<Eigen::Infinity>();
  std::vector<int> gaps;
  for (Index i = 0; i < bound_count_; ++i) {
    const int gap = model_.lifting_gap[i];
    if (gap >= 0 && !is_open(i, y[i]) && T_.col(gap).dot(contact.force) < -tolerance)
      gaps.push_back(gap);
  }
  return gaps;
}

/// Limits y at nodes with a lifting gap. A part that can move as a whole has hardly any stiffness
/// until it meets another.
void NonlinearMap::limit_gaps(const NonlinearState& state, VectorXd& y) const {
  double largest = 0;
  for (const int n : model_.inner) largest = std::max(largest, std::abs(state.u[n]));
  const double limit = widest_gap * std::sqrt(largest);
  for (Index i = 0; i < bound_count_; ++i)
    if (model_.lifting_gap[i] >= 0) y[i] = std::clamp(y[i], -limit, limit);
}

/// Returns u on B, 0 where the gap is open.
VectorXd NonlinearMap::u_on_boundary(const VectorXd& y) const {
  VectorXd u = y.cwiseProduct(y.cwiseAbs());
  for (Index i = 0; i < bound_count_; ++i)
    if (is_open(i, y[i])) u[i] = 0;
  return u;
}

/// Stores y|y| at nodes with a lifting gap, where the inflation has 0 for an open one.
void NonlinearMap::keep_gaps(const VectorXd& y, NonlinearState& state) const {
  for (Index i = 0; i < bound_count_; ++i)
    if (model_.lifting_gap[i] >= 0) state.u[model_.bound[i]] = y[i] * std::abs(y[i]);
}

/// Returns the rise of the heights by the open gaps on B, #N.
VectorXd NonlinearMap::opening(const VectorXd& y) const {
  VectorXd rise = VectorXd::Zero(model_.fixed_u.size());
  for (Index i = 0; i < bound_count_; ++i)
    if (is_open(i, y[i])) rise += std::abs(y[i]) * T_.col(model_.lifting_gap[i]);
  return rise;
}

/// Returns the f of the contact step, #N: less the heights of open gaps, which it keeps closed.
VectorXd NonlinearMap::known_f(const NonlinearState& state) const {
  VectorXd f = fixed_f_;
  for (const int n : contact_nodes_) f[n] = root(n).f(state.u[n]);
  const VectorXd y = y_on_boundary(state);
  for (Index i = 0; i < bound_count_; ++i) f[model_.bound[i]] = is_open(i, y[i]) ? 0 : y[i];
  return f - opening(y);
}

/// Returns e, #B.
VectorXd NonlinearMap::gradient_on_boundary(const VectorXd& y, const Contact& contact,
                                            const VectorXd& boundary_slope) const {
  VectorXd gradient(bound_count_);
  for (Index i = 0; i < bound_count_; ++i) {
    const int n = model_.bound[i];
    if (is_open(i, y[i])) {
      const double multiplier = T_.col(model_.lifting_gap[i]).dot(contact.force);
      gradient[i] = model_.sign[n] < 0 ? multiplier : -multiplier;
      continue;
    }
    const double lambda = model_.lambda_bnd * model_.bound_mass[i];
    gradient[i] = lambda * y[i] + 2 * std::abs(y[i]) * boundary_slope[i] - contact.force[n];
  }
  return gradient;
}

/// Returns sigma, #B: the derivative of the first two terms of e, or a larger value where that
/// would be too small or negative.
VectorXd NonlinearMap::sigma_on_boundary(const VectorXd& y, const VectorXd& boundary_slope) const {
  VectorXd sigma(bound_count_);
  for (Index i = 0; i < bound_count_; ++i) {
    const int n = model_.bound[i];
    const double slope = boundary_slope[i];
    const double lambda = model_.lambda_bnd * model_.bound_mass[i];
    const bool negative =
        is_open(i, y[i]) ? y[i] > 0 : y[i] < 0 || (y[i] == 0 && model_.sign[n] < 0);
    const double derivative = lambda + 2 * (negative ? -slope : slope);
    sigma[i] = derivative >= least_sigma * lambda ? derivative : lambda + 2 * std::abs(slope);
  }
  return sigma;
}

/// The contact step knows f only at contact nodes and on B, so the other nodes get it here.
void NonlinearMap::find_heights(NonlinearState& state) const {
  state.h = contact_step_.heights();
  const VectorXd rise = opening(y_on_boundary(state)) / model_.metric.scale;
  for (Index n = 0; n < rise.size(); ++n) state.h[n] += rise[n];
  for (const int n : other_nodes_) state.h[n] += signed_root(state.u[n]) / model_.metric.scale;
}

/// Returns k at mixed nodes, kept positive.
VectorXd NonlinearMap::mixed_stiffness(const NonlinearState& state) const {
  VectorXd stiffness(compliance_.size());
  for (Index i = 0; i < compliance_.size(); ++i) {
    const int n = mixed_nodes_[i];
    const double u = state.u[n];
    const double du_df = 1 / root(n).slope(u);
    const double growth = std::max(du_df * du_df, 4 * smallest_u) / compliance_[i];
    const double curvature = 2 * (u < 0 ? -state.load[n] : state.load[n]);
    stiffness[i] = std::max(growth + curvature, 0.5 * growth);
  }
  return stiffness;
}

/// Returns p at mixed nodes.
VectorXd NonlinearMap::mixed_linear_term(const NonlinearState& state) const {
  VectorXd linear(compliance_.size());
  for (Index i = 0; i < compliance_.size(); ++i) {
    const int n = mixed_nodes_[i];
    const double du_df = 1 / root(n).slope(state.u[n]);
    linear[i] = -du_df * state.load[n];
  }
  return linear;
}

VectorXd NonlinearMap::next_load(const VectorXd& f, const NonlinearState& state,
                                 const Contact& contact) const {
  VectorXd load = VectorXd::Zero(f.size());
  for (const int n : contact_nodes_) load[n] = contact.force[n] * root(n).slope(state.u[n]);
  for (Index i = 0; i < compliance_.size(); ++i) {
    const int n = mixed_nodes_[i];
    const double next = root(n).u(f[n] + contact.change[i]);
    load[n] = state.load[n] + (next - state.u[n]) / compliance_[i];
  }
  return load;
}

/// Returns C: `share` times the change of u at each mixed node under unit loads on all of them.
VectorXd NonlinearMap::mixed_compliance(double share) const {
  const auto count = static_cast<Index>(mixed_nodes_.size());
  VectorXd compliance(count);
  if (count == 0) return compliance;
  VectorXd load = VectorXd::Zero(model_.load.size());
  for (Index i = 0; i < count; ++i) load[mixed_nodes_[i]] = 1;
  const VectorXd u = response_.compliance(load);
  for (Index i = 0; i < count; ++i) compliance[i] = share * std::max(1e-12, u[mixed_nodes_[i]]);
  return compliance;
}

}  // namespace relievo::relief

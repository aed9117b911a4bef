#include "relief/joint/joint_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "relief/joint/bound_modes.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// |u| is taken at least so large for the resistance of a soft node.
constexpr double smallest_u = 1e-3;
/// A spring on B is kept at least so stiff, relative to lambda_bnd alone.
constexpr double softest = 0.2;
/// Of a residual that is smooth.
constexpr Index smooth_samples = 1000;
/// Of the largest force, for a gap that would have to pull.
constexpr double least_pull = 1e-6;
/// Of the largest f, for gaps on B.
constexpr double widest_gap = 4;
/// Of the largest f on B, to see how its slope changes.
constexpr double relative_rise = 1e-4;

/// #N: whether the node is in a pair.
std::vector<uint8_t> pressed_nodes(const DepthProblem& problem) {
  std::vector<uint8_t> pressed(problem.forest.group.size(), 0);
  for (const DepthGap& gap : problem.forest.gaps) pressed[gap.parent] = pressed[gap.child] = 1;
  return pressed;
}

/// The inner nodes that are in pairs, or those that are not.
std::vector<int> inner_nodes(const JointModel& model, const DepthProblem& problem, bool in_pairs) {
  const std::vector<uint8_t> pressed = pressed_nodes(problem);
  std::vector<int> nodes;
  for (const int n : model.inner)
    if ((pressed[n] != 0) == in_pairs) nodes.push_back(n);
  return nodes;
}

std::vector<int> soft_nodes(const JointModel& model, std::vector<int> contact, bool all) {
  const auto firm = [&](int n) { return !all && model.sign[n] != 0; };
  contact.erase(std::remove_if(contact.begin(), contact.end(), firm), contact.end());
  return contact;
}

}  // namespace

JointMap::JointMap(const JointSystems& systems, const Softness& softness)
    : model_(systems.inflation.model()),
      response_(systems.inflation),
      smooth_root_(softness.width),
      nodes_(inner_nodes(model_, systems.order.problem, true)),
      apart_(inner_nodes(model_, systems.order.problem, false)),
      soft_(soft_nodes(model_, nodes_, softness.all)),
      held_f_(model_.held.unaryExpr(&signed_root)),
      contact_step_(model_, systems.order, soft_),
      gap_columns_(systems.order.problem.variables.T),
      bound_step_(systems.bound),
      bounds_(model_.bound_mass.size()),
      stiffening_(VectorXd::Zero(bounds_)),
      compliance_(compliance_of_soft_nodes(softness.share)) {
  if (softness.loose > 0) bound_step_.resist_opening(softness.loose);
}

VectorXd JointMap::pack(const JointState& state) const {
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

void JointMap::unpack(const VectorXd& x, JointState& state) const {
  const auto contacts = static_cast<Index>(nodes_.size());
  for (Index i = 0; i < contacts; ++i) {
    const int n = nodes_[i];
    const int sign = model_.sign[n];
    const double least = sign * state.u[n] > 0 ? 0.1 * state.u[n] : 0;
    state.u[n] = sign != 0 && sign * x[i] < sign * least ? least : x[i];
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

VectorXd JointMap::measured(const VectorXd& residual) const {
  const auto contacts = static_cast<Index>(nodes_.size());
  const Index stride = 1 + contacts / smooth_samples;
  const Index samples = (contacts + stride - 1) / stride;
  const Index rest = residual.size() - contacts;
  VectorXd result(samples + rest);
  for (Index i = 0; i < samples; ++i) result[i] = residual[i * stride];
  result.tail(rest) = residual.tail(rest);
  return result;
}

JointMap::Answer JointMap::answer_to(const JointState& state, const RunContext& context) {
  Answer answer;
  const VectorXd f = fixed_f(state);
  answer.contact = contact_step_.solve(f, springs(state), context);
  if (answer.contact.status != SolveStatus::solved) return answer;
  answer.load = next_load(f, state, answer.contact);
  answer.excess = response_.excess(answer.load);
  answer.slope = slope_on_bound(f_on_bound(state), answer.contact, answer.excess);
  return answer;
}

JointMap::Answer JointMap::answer_to_change(const JointState& state, const VectorXd& change,
                                            const RunContext& context) {
  const VectorXd before = f_on_bound(state);
  const VectorXd after = before + change;
  JointState changed = state;
  changed.u += response_.extension(squares_on_bound(after) - squares_on_bound(before));
  set_loose(after, changed);
  return answer_to(changed, context);
}

SolveStatus JointMap::apply(JointState& state, JointStep& step, const RunContext& context) {
  Answer answer = answer_to(state, context);
  if (answer.contact.status != SolveStatus::solved) return answer.contact.status;
  const Excess& excess = answer.excess;
  slope_ = answer.slope;
  VectorXd f_bound = f_on_bound(state);
  pulled_ = pulled_gaps(f_bound, answer.contact);
  const SolveStatus moved =
      bound_step_.move(slope_, springs_on_bound(f_bound, excess), context, f_bound);
  if (moved != SolveStatus::solved) return moved;
  keep_loose_within_reach(state, f_bound);
  state.load = std::move(answer.load);
  const VectorXd u_bound = squares_on_bound(f_bound);
  state.u = response_.inflate(excess, u_bound);
  set_loose(f_bound, state);
  step.factorisations = answer.contact.factorisations;
  step.energy.inflation = excess.energy;
  step.energy.boundary = model_.lambda_bnd * model_.bound_mass.dot(u_bound.cwiseAbs());
  step.energy.shift = answer.contact.shift_energy;
  return SolveStatus::solved;
}

VectorXd JointMap::f_on_bound(const JointState& state) const {
  VectorXd f(bounds_);
  for (Index i = 0; i < bounds_; ++i) f[i] = signed_root(state.u[model_.bound[i]]);
  return f;
}

bool JointMap::is_open(Index i, double f) const {
  return model_.loose_gap[i] >= 0 && f * (model_.sign[model_.bound[i]] < 0 ? -1 : 1) < 0;
}

/// Those that are closed and would have to pull.
std::vector<int> JointMap::pulled_gaps(const VectorXd& f, const Contact& contact) const {
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
void JointMap::keep_loose_within_reach(const JointState& state, VectorXd& f_bound) const {
  double largest = 0;
  for (const int n : model_.inner) largest = std::max(largest, std::abs(state.u[n]));
  const double reach = widest_gap * std::sqrt(largest);
  for (Index i = 0; i < bounds_; ++i)
    if (model_.loose_gap[i] >= 0) f_bound[i] = std::clamp(f_bound[i], -reach, reach);
}

/// u there; 0 where the gap is open.
VectorXd JointMap::squares_on_bound(const VectorXd& f) const {
  VectorXd u = f.cwiseProduct(f.cwiseAbs());
  for (Index i = 0; i < bounds_; ++i)
    if (is_open(i, f[i])) u[i] = 0;
  return u;
}

/// On loose B, where the gap is not in the inflation.
void JointMap::set_loose(const VectorXd& f, JointState& state) const {
  for (Index i = 0; i < bounds_; ++i)
    if (model_.loose_gap[i] >= 0) state.u[model_.bound[i]] = f[i] * std::abs(f[i]);
}

/// #N: by how much the gaps that are open there move the heights.
VectorXd JointMap::opening(const VectorXd& f_bound) const {
  VectorXd rise = VectorXd::Zero(model_.held.size());
  for (Index i = 0; i < bounds_; ++i)
    if (is_open(i, f_bound[i]))
      rise += std::abs(f_bound[i]) * gap_columns_.col(model_.loose_gap[i]);
  return rise;
}

VectorXd JointMap::fixed_f(const JointState& state) const {
  VectorXd f = held_f_;
  for (const int n : nodes_) f[n] = root(n).f(state.u[n]);
  const VectorXd f_bound = f_on_bound(state);
  for (Index i = 0; i < bounds_; ++i) f[model_.bound[i]] = is_open(i, f_bound[i]) ? 0 : f_bound[i];
  return f - opening(f_bound);
}

/// The slope of the energy / 2 with respect to f on B: its own, that of the inflation, and the
/// force of the contact against it.
VectorXd JointMap::slope_on_bound(const VectorXd& f, const Contact& contact,
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
VectorXd JointMap::springs_on_bound(const VectorXd& f, const Excess& excess) const {
  VectorXd springs = stiffening_;
  for (Index i = 0; i < bounds_; ++i) {
    const int n = model_.bound[i];
    const double slope = excess.slope[i];
    const double own = model_.lambda_bnd * model_.bound_mass[i];
    const bool sunk = is_open(i, f[i]) ? f[i] > 0 : f[i] < 0 || (f[i] == 0 && model_.sign[n] < 0);
    const double resistance = own + 2 * (sunk ? -slope : slope);
    springs[i] += resistance >= softest * own ? resistance : own + 2 * std::abs(slope);
  }
  return springs;
}

SolveStatus JointMap::stiffen(const JointState& state, const RunContext& context) {
  if (bounds_ == 0 || bound_step_.is_known()) return SolveStatus::solved;
  const VectorXd& direction = bound_step_.direction();
  const double rise = relative_rise * f_on_bound(state).lpNorm<Eigen::Infinity>();
  const Answer answer = answer_to_change(state, rise * direction, context);
  if (answer.contact.status != SolveStatus::solved) return answer.contact.status;
  const VectorXd missing =
      (answer.slope - slope_) / rise - bound_step_.stiffness_against(direction);
  stiffening_ += direction.cwiseProduct(missing).cwiseMax(0);
  return SolveStatus::solved;
}

BoundStiffness JointMap::bound_stiffness() const {
  BoundStiffness stiffness = bound_step_.stiffness();
  if (bounds_ > 0) stiffness.K.diagonal() += stiffening_ / model_.lambda_shift;
  return stiffness;
}

class JointMap::Prober {
 public:
  Prober(JointMap& map, const JointState& state, const RunContext& context)
      : map_(map), state_(state), context_(context), f_(map.f_on_bound(state)) {}

  SolveStatus start() {
    const Answer answer = map_.answer_to(state_, context_);
    slope_ = answer.slope;
    springs_ = map_.springs_on_bound(f_, answer.excess);
    rise_ = relative_rise * f_.lpNorm<Eigen::Infinity>();
    return answer.contact.status;
  }

  /// Where a force at an end of B takes f, and where what K answers too much to that does.
  SolveStatus probe(int end, BoundProbes& probes) {
    VectorXd force = VectorXd::Zero(f_.size());
    force[end] = map_.bound_step_.direction()[end];
    VectorXd change;
    SolveStatus status = yield_to(force, change);
    if (status != SolveStatus::solved) return status;
    status = measure(change, probes);
    if (status != SolveStatus::solved) return status;
    const VectorXd step = probes.steps.rightCols<1>();
    status = yield_to(step - probes.slopes.rightCols<1>(), change);
    if (status != SolveStatus::solved) return status;
    const VectorXd first = probes.changes.rightCols<1>();
    return measure(change - change.dot(step) / first.dot(step) * first, probes);
  }

 private:
  /// change = K^-1 force
  SolveStatus yield_to(const VectorXd& force, VectorXd& change) {
    VectorXd f = f_;
    const double size = rise_ / std::max(force.lpNorm<Eigen::Infinity>(), 1e-300);
    const SolveStatus status = map_.bound_step_.move(-size * force, springs_, context_, f);
    change = f - f_;
    return status;
  }

  /// Of length 1 by K; nothing where that means nothing.
  SolveStatus measure(VectorXd change, BoundProbes& probes) {
    const double largest = change.lpNorm<Eigen::Infinity>();
    if (!(largest > 0)) return SolveStatus::solved;
    change *= rise_ / largest;
    const Answer answer = map_.answer_to_change(state_, change, context_);
    if (answer.contact.status != SolveStatus::solved) return answer.contact.status;
    append(change / rise_, probes.changes);
    append(map_.bound_step_.stiffness_against(change / rise_), probes.steps);
    append((answer.slope - slope_) / rise_, probes.slopes);
    return SolveStatus::solved;
  }

  static void append(const VectorXd& column, Eigen::MatrixXd& A) {
    A.conservativeResize(column.size(), A.cols() + 1);
    A.rightCols<1>() = column;
  }

  JointMap& map_;
  const JointState& state_;
  const RunContext& context_;
  VectorXd f_;
  VectorXd slope_;
  VectorXd springs_;
  double rise_ = 0;
};

SolveStatus JointMap::probe_ends(const JointState& state, const RunContext& context,
                                 BoundStiffness& stiffness) {
  if (bounds_ == 0 || !soft_.empty()) return SolveStatus::solved;
  Prober prober(*this, state, context);
  BoundProbes probes;
  SolveStatus status = prober.start();
  for (const int end : model_.bound_ends)
    if (status == SolveStatus::solved) status = prober.probe(end, probes);
  if (status == SolveStatus::solved)
    stiffness.K += missing_stiffness(modes_of(probes)) / model_.lambda_shift;
  return status == SolveStatus::interrupted ? status : SolveStatus::solved;
}

/// The contact knows no inflation where parts do not press.
SolveStatus JointMap::find_heights(JointState& state, const RunContext& context) {
  const SolveStatus status = contact_step_.complete(context);
  if (status != SolveStatus::solved) return status;
  state.h = contact_step_.heights();
  const VectorXd rise = opening(f_on_bound(state)) / model_.metric.scale;
  for (Index n = 0; n < rise.size(); ++n) state.h[n] += rise[n];
  for (const int n : apart_) state.h[n] += signed_root(state.u[n]) / model_.metric.scale;
  return status;
}

/// For a change of f at a soft node: the inflation holds it with the load times du/df, and the
/// load grows with u as the compliance says.
Springs JointMap::springs(const JointState& state) const {
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
VectorXd JointMap::next_load(const VectorXd& f, const JointState& state,
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
VectorXd JointMap::compliance_of_soft_nodes(double share) const {
  const auto count = static_cast<Index>(soft_.size());
  VectorXd compliance(count);
  if (count == 0) return compliance;
  VectorXd load = VectorXd::Zero(model_.load.size());
  for (Index i = 0; i < count; ++i) load[soft_[i]] = 1;
  const VectorXd u = response_.compliance(load);
  for (Index i = 0; i < count; ++i) compliance[i] = share * std::max(1e-12, u[soft_[i]]);
  return compliance;
}

}  // namespace relievo

#include "relief/nonlinear/solve_nonlinear.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "kernel/base/workers.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflate.h"
#include "relief/inflation/poisson_system.h"
#include "relief/inflation/raise_bumps.h"
#include "relief/nonlinear/nonlinear_iteration.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/nonlinear/recall.h"
#include "relief/ordering/order_depth.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// How often nodes with the wrong sign are looked for.
constexpr int sign_rounds = 3;
/// How often gaps that would pull are let go, and how long that may take each time.
constexpr int release_rounds = 3;
constexpr int release_iterations = 40;

bool is_positive(double value) { return value > 0 && std::isfinite(value); }

Status check_options(const NonlinearOptions& options) {
  if (!(options.lambda_bnd >= min_lambda_bnd && options.lambda_bnd <= max_lambda_bnd))
    return Error{ErrorCode::usage, "lambda_bnd must lie between 1e-6 and 1e6", "lambda_bnd"};
  if (!(options.lambda_shift >= min_lambda_shift && options.lambda_shift <= max_lambda_shift))
    return Error{ErrorCode::usage, "lambda_shift must lie between 0.001 and 100", "lambda_shift"};
  if (!is_positive(options.tolerance))
    return Error{ErrorCode::usage, "the tolerance must be positive", "tolerance"};
  if (options.max_iterations < 1)
    return Error{ErrorCode::usage, "there must be at least one iteration", "max_iterations"};
  if (!std::is_sorted(options.snapshots.begin(), options.snapshots.end()))
    return Error{ErrorCode::usage, "the steps must rise", "snapshots"};
  if (options.anderson_depth < 0)
    return Error{ErrorCode::usage, "the depth must not be negative", "anderson_depth"};
  OrderingOptions ordering;
  ordering.epsilon = options.epsilon;
  return check_options(ordering);
}

NonlinearState first_state(const NonlinearModel& model, const Inflation& start) {
  NonlinearState state;
  const double area = model.metric.scale * model.metric.scale;
  state.u = model.held;
  for (const std::vector<int>* nodes : {&model.inner, &model.bound})
    for (const int n : *nodes) state.u[n] = area * start.u[n];
  state.load = VectorXd::Zero(state.u.size());
  return state;
}

VectorXd in_scene_units(const std::vector<double>& values, double factor) {
  VectorXd result(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index n = 0; n < result.size(); ++n) result[n] = factor * values[n];
  return result;
}

/// Holds these gaps (a list with -1 for none) at what the iteration says, or lets them go again,
/// as they were: both have the same matrix.
void hold_gaps(const std::vector<int>& gaps, bool held, DepthSystem& system) {
  std::vector<uint8_t> meant(system.closed.size(), 0);
  for (const int gap : gaps)
    if (gap >= 0) meant[gap] = 1;
  GapVariables& variables = system.problem.variables;
  for (DepthGap& gap : system.problem.forest.gaps) {
    if (meant[gap.child] == 0) continue;
    gap.equal = held;
    variables.fixed[gap.child] = system.qp.fixed[gap.child] = held;
    variables.bounded[gap.child] = system.qp.bounded[gap.child] = !held;
  }
}

/// The iteration with what it solves with.
class NonlinearSolver {
 public:
  NonlinearSolver(const OrderingInput& input, const NonlinearOptions& options,
                  const NonlinearMemory& known, OrderingSystem& system, const RunContext& context)
      : input_(input),
        known_(known),
        options_(options),
        system_(system),
        context_(context),
        model_(make_joint_model(input, system.metric)),
        recalled_(!known.marks.empty()) {
    model_.lambda_bnd = options.lambda_bnd;
    model_.lambda_shift = options.lambda_shift;
    run_.state = first_state(model_, input.inflation);
    u_start_ = run_.state.u;
  }

  /// Fills in inflation, ordering and snapshots.
  Status solve(NonlinearSolution& solution) {
    set_pairs({input_.mesh, input_.discretisation, input_.scene}, system_, context_);
    if (context_.cancelled()) return interrupted_error();
    DepthSystem& order_system = system_.system;
    order_system.closed = gaps_like(input_.mesh, order_system.problem, known_.contacts);
    find_loose_bound(order_system.problem.forest, model_);
    recall(input_.mesh, model_, input_.mesh.constraints, known_.marks, run_.state);
    if (Status status = iterate_holding(options_); !status) return status;
    if (run_.report.status == NonlinearStatus::solved && !is_mixed(model_))
      if (Status status = release_pulled(); !status) return status;
    for (const KeptState& kept : std::exchange(run_.kept, {})) {
      NonlinearSnapshot snapshot{kept.step, inflation_of(kept.u), {}};
      const Status status = order(snapshot.inflation, snapshot.ordering);
      if (!status) return status;
      solution.snapshots.push_back(std::move(snapshot));
    }
    solution.inflation = inflation_of(run_.state.u);
    return order(solution.inflation, solution.ordering);
  }

  NonlinearMemory memory() const {
    if (run_.report.status != NonlinearStatus::solved) return {};
    return {remember(input_.mesh, model_, *system_.pairs, u_start_, run_.state),
            contacts_of(input_.mesh, run_.state.h)};
  }

  /// With the energy at the end.
  NonlinearReport report(const Ordering& ordering) const {
    NonlinearReport report = run_.report;
    const VectorXd g = in_scene_units(ordering.g, model_.metric.scale);
    report.energy = nonlinear_energy(model_, with_signs(run_.state.u), g);
    return report;
  }

 private:
  /// Iterates; where u comes out with the wrong sign, as obtuse faces allow, holds it at 0 and
  /// goes on.
  Status iterate(const NonlinearOptions& options) {
    VectorXd& u = run_.state.u;
    BoundStep bound(model_, system_.system);
    if (Status status = prepare(bound); !status) return status;
    for (int i = 0;; ++i) {
      if (!response_) response_.emplace(model_);
      if (!response_->sound())
        return Error{ErrorCode::internal, "the inflation has no finite solution", ""};
      if (std::exchange(recalled_, false)) inflate_recalled();
      const Status status =
          iterate_nonlinear({*response_, system_.system, bound}, options, context_, run_);
      if (!status) return status;
      if (i == sign_rounds || !hold_wrong_signs(u, model_)) break;
      response_.reset();
    }
    return Done{};
  }

  /// Iterates with the gaps on loose B held at what the iteration says of them.
  Status iterate_holding(const NonlinearOptions& options) {
    DepthSystem& order_system = system_.system;
    hold_gaps(model_.loose_gap, true, order_system);
    const Status status = iterate(options);
    hold_gaps(model_.loose_gap, false, order_system);
    for (size_t i = 0; i < model_.bound.size(); ++i)
      if (model_.loose_gap[i] >= 0)
        order_system.closed[model_.loose_gap[i]] = lifted(run_.state.u, i) >= 0;
    return status;
  }

  /// Where parts press beside B, u may rise there beyond what closes the gap, at little cost, and
  /// what holds the gap would pull. Lets such gaps go, as long as that lowers the energy.
  Status release_pulled() {
    NonlinearOptions options = options_;
    options.max_iterations = std::min(options.max_iterations, release_iterations);
    run_.once = true;
    for (int round = 0; round < release_rounds && !run_.pulled.empty(); ++round) {
      const NonlinearRun before = run_;
      for (int& gap : model_.loose_gap)
        if (std::count(before.pulled.begin(), before.pulled.end(), gap) > 0) gap = -1;
      run_.pulled.clear();
      double energies[2] = {0, 0};
      if (Status status = find_energy(energies[0]); !status) return status;
      if (Status status = iterate_holding(options); !status) return status;
      if (Status status = find_energy(energies[1]); !status) return status;
      if (run_.report.status == NonlinearStatus::solved && energies[1] < energies[0]) continue;
      run_ = before;
      break;
    }
    return Done{};
  }

  /// With the best heights for u.
  Status find_energy(double& energy) {
    const double scale = model_.metric.scale;
    const VectorXd u = with_signs(run_.state.u);
    const VectorXd f = u.unaryExpr(&signed_root);
    Ordering ordering;
    const SolveStatus solved =
        solve_heights(system_.system, model_.metric, f / scale, ordering, context_);
    energy = nonlinear_energy(model_, u, in_scene_units(ordering.h, scale) - f).total();
    return check_solved(solved);
  }

  /// u there in the direction in which gaps lift f; negative where one is open.
  double lifted(const VectorXd& u, size_t i) const {
    const int n = model_.bound[i];
    return model_.sign[n] < 0 ? -u[n] : u[n];
  }

  Status prepare(BoundStep& bound) {
    SolveStatus status = SolveStatus::solved;
    run_tasks(2, [&](int task) {
      if (task == 0)
        status = bound.prepare(context_);
      else if (!response_)
        response_.emplace(model_);
    });
    return check_solved(status);
  }

  /// What was recalled are values node by node: u becomes the inflation under the loads.
  void inflate_recalled() {
    VectorXd& u = run_.state.u;
    const VectorXd known = u;
    const VectorXd inflated = with_signs(u);
    const VectorXd u_bound = inflated(model_.bound);
    u = response_->inflate(response_->excess(run_.state.load), u_bound);
    for (const int n : model_.bound) u[n] = known[n];
  }

  /// What has the wrong sign is a gap, or left of obtuse faces.
  VectorXd with_signs(VectorXd u) const {
    for (Eigen::Index n = 0; n < u.size(); ++n)
      if (model_.sign[n] * u[n] < 0) u[n] = 0;
    for (size_t i = 0; i < model_.bound.size(); ++i)
      if (model_.loose_gap[i] >= 0 && lifted(u, i) < 0) u[model_.bound[i]] = 0;
    return u;
  }

  Inflation inflation_of(const VectorXd& u_and_gaps) const {
    const VectorXd u = with_signs(u_and_gaps);
    Inflation inflation = make_inflation(input_.discretisation.gradients, u, model_.metric.scale);
    raise_bumps({input_.mesh, input_.discretisation, input_.scene}, options_.bumps, inflation);
    return inflation;
  }

  /// The exact depth order for an inflation.
  Status order(const Inflation& inflation, Ordering& ordering) {
    const SolveStatus solved = solve_heights(system_.system, model_.metric,
                                             inflated_heights(inflation.u), ordering, context_);
    if (Status status = check_solved(solved); !status) return status;
    finish_ordering({input_.mesh, input_.discretisation, inflation, input_.scene}, ordering);
    return Done{};
  }

  const OrderingInput& input_;
  const NonlinearMemory& known_;
  const NonlinearOptions& options_;
  OrderingSystem& system_;
  const RunContext& context_;
  NonlinearModel model_;
  bool recalled_;  ///< whether `u` holds what is known of another mesh
  std::optional<InflationResponse> response_;
  VectorXd u_start_;
  NonlinearRun run_;
};

}  // namespace

Result<NonlinearSolution> solve_nonlinear(const OrderingInput& input,
                                          const NonlinearOptions& options,
                                          const NonlinearMemory& known, OrderingSystem& system,
                                          const RunContext& context) {
  assert(input.inflation.u.size() == input.mesh.node_vertex.size());
  assert(static_cast<int>(input.scene.parts.size()) == input.mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  const SurfaceInput surface{input.mesh, input.discretisation, input.scene};
  set_surface(surface, options.epsilon, system, context);
  set_leans(surface, input.inflation, options.wanted, system);
  NonlinearSolver solver(input, options, known, system, context);
  NonlinearSolution solution;
  if (Status status = solver.solve(solution); !status) return status.error();
  solution.report = solver.report(solution.ordering);
  solution.memory = solver.memory();
  context.report("nonlinear", 1);
  return solution;
}

Result<NonlinearSolution> solve_nonlinear(const LayeredMesh& mesh, const Scene& scene,
                                          const Inflation& start, const NonlinearOptions& options,
                                          const RunContext& context) {
  const Discretisation discretisation = discretise(mesh, context);
  if (context.cancelled()) return interrupted_error();
  OrderingSystem system;
  return solve_nonlinear({mesh, discretisation, start, scene}, options, {}, system, context);
}

}  // namespace relievo::relief

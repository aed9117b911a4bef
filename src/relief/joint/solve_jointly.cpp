#include "relief/joint/solve_jointly.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "kernel/base/workers.h"
#include "relief/discretisation/discretise.h"
#include "relief/inflation/poisson_terms.h"
#include "relief/inflation/raise_bumps.h"
#include "relief/joint/inflation_response.h"
#include "relief/joint/joint_iteration.h"
#include "relief/joint/joint_model.h"
#include "relief/joint/recall.h"
#include "relief/ordering/finish_ordering.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// How often nodes with the wrong sign are looked for.
constexpr int sign_rounds = 3;

bool is_positive(double value) { return value > 0 && std::isfinite(value); }

Status check_options(const JointOptions& options) {
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

JointState first_state(const JointModel& model, const Inflation& start) {
  JointState state;
  state.u.resize(static_cast<Eigen::Index>(start.u.size()));
  const double area = model.metric.scale * model.metric.scale;
  for (Eigen::Index n = 0; n < state.u.size(); ++n) state.u[n] = area * start.u[n];
  state.load = VectorXd::Zero(state.u.size());
  return state;
}

VectorXd in_scene_units(const std::vector<double>& values, double factor) {
  VectorXd result(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index n = 0; n < result.size(); ++n) result[n] = factor * values[n];
  return result;
}

/// The iteration with what it solves with.
class JointSolver {
 public:
  JointSolver(const OrderingInput& input, const JointOptions& options, const JointMemory& known,
              OrderingSystem& system, const RunContext& context)
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
    run_.bound = known.bound;
    recall(input.mesh, model_, input.mesh.constraints, known.marks, run_.state);
  }

  /// Fills in inflation, ordering and snapshots.
  Status solve(JointSolution& solution) {
    set_pairs({input_.mesh, input_.discretisation, input_.scene}, system_, context_);
    if (context_.cancelled()) return interrupted_error();
    DepthSystem& order_system = system_.system;
    order_system.closed = gaps_like(input_.mesh, order_system.problem, known_.contacts);
    if (Status status = iterate(); !status) return status;
    for (const KeptState& kept : std::exchange(run_.kept, {})) {
      JointSnapshot snapshot{kept.step, inflation_of(kept.u), {}};
      const Status status = order(snapshot.inflation, snapshot.ordering);
      if (!status) return status;
      solution.snapshots.push_back(std::move(snapshot));
    }
    solution.inflation = inflation_of(run_.state.u);
    return order(solution.inflation, solution.ordering);
  }

  JointMemory memory() const {
    if (run_.report.status != JointStatus::solved) return {};
    return {remember(input_.mesh, model_, *system_.pairs, u_start_, run_.state),
            contacts_of(input_.mesh, run_.state.h), run_.bound};
  }

  /// With the energy at the end.
  JointReport report(const Ordering& ordering) const {
    JointReport report = run_.report;
    const VectorXd g = in_scene_units(ordering.g, model_.metric.scale);
    report.energy = joint_energy(model_, run_.state.u, g);
    return report;
  }

 private:
  /// Iterates; where u comes out with the wrong sign, as obtuse faces allow, holds it at 0 and
  /// goes on.
  Status iterate() {
    VectorXd& u = run_.state.u;
    BoundStep bound(model_, system_.system);
    if (Status status = prepare(bound); !status) return status;
    for (int i = 0;; ++i) {
      if (!response_) response_.emplace(model_);
      if (!response_->sound())
        return Error{ErrorCode::internal, "the inflation has no finite solution", ""};
      if (std::exchange(recalled_, false)) inflate_recalled();
      const Status status =
          iterate_jointly({*response_, system_.system, bound}, options_, context_, run_);
      if (!status) return status;
      if (i == sign_rounds || !hold_wrong_signs(u, model_)) break;
      response_.reset();
    }
    for (Eigen::Index n = 0; n < u.size(); ++n)
      if (model_.sign[n] * u[n] < 0) u[n] = 0;
    return Done{};
  }

  Status prepare(BoundStep& bound) {
    SolveStatus status = SolveStatus::solved;
    run_tasks(2, [&](int task) {
      if (task == 0)
        status = bound.prepare(run_.bound, context_);
      else if (!response_)
        response_.emplace(model_);
    });
    return check_solved(status);
  }

  /// What was recalled are values node by node: u becomes the inflation under the loads.
  void inflate_recalled() {
    VectorXd u_bound(static_cast<Eigen::Index>(model_.bound.size()));
    for (size_t i = 0; i < model_.bound.size(); ++i)
      u_bound[static_cast<Eigen::Index>(i)] = run_.state.u[model_.bound[i]];
    run_.state.u = response_->inflate(response_->excess(run_.state.load), u_bound);
  }

  Inflation inflation_of(const VectorXd& u) const {
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
  const JointMemory& known_;
  const JointOptions& options_;
  OrderingSystem& system_;
  const RunContext& context_;
  JointModel model_;
  bool recalled_;  ///< whether `u` holds what is known of another mesh
  std::optional<InflationResponse> response_;
  VectorXd u_start_;
  JointRun run_;
};

}  // namespace

Result<JointSolution> solve_jointly(const OrderingInput& input, const JointOptions& options,
                                    const JointMemory& known, OrderingSystem& system,
                                    const RunContext& context) {
  assert(input.inflation.u.size() == input.mesh.node_vertex.size());
  assert(static_cast<int>(input.scene.parts.size()) == input.mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  set_surface({input.mesh, input.discretisation, input.scene}, options.epsilon, system, context);
  set_leans(input.mesh, input.scene, system);
  JointSolver solver(input, options, known, system, context);
  JointSolution solution;
  if (Status status = solver.solve(solution); !status) return status.error();
  solution.report = solver.report(solution.ordering);
  solution.memory = solver.memory();
  context.report("nonlinear", 1);
  return solution;
}

Result<JointSolution> solve_jointly(const LayeredMesh& mesh, const Scene& scene,
                                    const Inflation& start, const JointOptions& options,
                                    const RunContext& context) {
  const Discretisation discretisation = discretise(mesh, context);
  if (context.cancelled()) return interrupted_error();
  OrderingSystem system;
  return solve_jointly({mesh, discretisation, start, scene}, options, {}, system, context);
}

}  // namespace relievo

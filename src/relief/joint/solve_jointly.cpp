#include "relief/joint/solve_jointly.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "relief/inflation/poisson_terms.h"
#include "relief/joint/inflation_response.h"
#include "relief/joint/joint_iteration.h"
#include "relief/joint/joint_model.h"
#include "relief/joint/recall.h"
#include "relief/ordering/order_rounds.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// How often nodes with the wrong sign are looked for.
constexpr int sign_rounds = 3;

bool is_positive(double value) { return value > 0 && std::isfinite(value); }

Status check_options(const JointOptions& options) {
  if (!(options.lambda_bnd >= min_lambda_bnd && options.lambda_bnd <= max_lambda_bnd))
    return Error{ErrorCode::usage, "lambda_bnd must lie between 1e-6 and 1e6", "lambda_bnd"};
  if (!is_positive(options.lambda_shift))
    return Error{ErrorCode::usage, "lambda_shift must be positive", "lambda_shift"};
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
  ordering.max_rounds = options.max_rounds;
  return check_options(ordering);
}

JointState first_state(const JointModel& model, const Inflation& start) {
  JointState state;
  state.u.resize(static_cast<Eigen::Index>(start.u.size()));
  const double area = model.metric.scale * model.metric.scale;
  for (Eigen::Index n = 0; n < state.u.size(); ++n) state.u[n] = area * start.u[n];
  state.load = VectorXd::Zero(state.u.size());
  state.slope = VectorXd::Zero(static_cast<Eigen::Index>(model.bound.size()));
  return state;
}

VectorXd in_scene_units(const std::vector<double>& values, double factor) {
  VectorXd result(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index n = 0; n < result.size(); ++n) result[n] = factor * values[n];
  return result;
}

/// Iterates; where u comes out with the wrong sign, as obtuse faces allow, holds it at 0 and goes
/// on.
Status iterate_with_signs(const DepthProblem& problem, const JointOptions& options,
                          const RunContext& context, JointModel& model, JointRun& run) {
  JointState& state = run.state;
  for (int i = 0;; ++i) {
    const InflationResponse response(model);
    if (!response.sound())
      return Error{ErrorCode::internal, "the inflation has no finite solution", ""};
    if (Status status = iterate_jointly(response, problem, options, context, run); !status)
      return status;
    if (i == sign_rounds || !hold_wrong_signs(state.u, model)) break;
  }
  for (Eigen::Index n = 0; n < state.u.size(); ++n)
    if (model.sign[n] * state.u[n] < 0) state.u[n] = 0;
  return Done{};
}

/// Solves round after round, each under more pairs and from where the last one ended.
class JointRounds {
 public:
  JointRounds(const LayeredMesh& mesh, const JointOptions& options, const RunContext& context,
              JointModel model, const JointStart& start)
      : mesh_(mesh), options_(options), context_(context), model_(std::move(model)) {
    run_.state = first_state(model_, start.inflation);
    u_start_ = run_.state.u;
    if (start.memory != nullptr) recall(mesh, model_, *start.memory, run_.state);
  }

  /// Leaves the solution for these pairs in `solution` and its heights in `ordering`.
  Status solve(const std::vector<DepthPair>& pairs, Ordering& ordering, JointSolution& solution) {
    const DepthProblem problem = make_depth_problem(mesh_.node_part, pairs);
    run_.report.round = ordering.rounds;
    if (Status status = iterate_with_signs(problem, options_, context_, model_, run_); !status)
      return status;
    for (const KeptState& kept : std::exchange(run_.kept, {})) {
      JointSnapshot snapshot{kept.step, inflation_of(kept.u), {}};
      const Status status = order(problem, snapshot.inflation, snapshot.ordering);
      if (!status) return status;
      solution.snapshots.push_back(std::move(snapshot));
    }
    solution.inflation = inflation_of(run_.state.u);
    return order(problem, solution.inflation, ordering);
  }

  JointMemory memory() const {
    if (run_.report.status != JointStatus::solved) return {};
    return remember(mesh_, model_, u_start_, run_.state);
  }

  /// With the energy at the end.
  JointReport report(const Ordering& ordering) const {
    JointReport report = run_.report;
    const VectorXd g = in_scene_units(ordering.g, model_.metric.scale);
    report.energy = joint_energy(model_, run_.state.u, g);
    return report;
  }

 private:
  Inflation inflation_of(const VectorXd& u) const {
    return make_inflation(mesh_, u, model_.metric.scale);
  }

  /// The exact depth order for an inflation.
  Status order(const DepthProblem& problem, const Inflation& inflation, Ordering& ordering) {
    return check_solved(solve_heights(problem, model_.metric, inflated_heights(inflation.u),
                                      closed_gaps(problem, run_.state.h), factor_, ordering,
                                      context_));
  }

  const LayeredMesh& mesh_;
  const JointOptions& options_;
  const RunContext& context_;
  JointModel model_;
  VectorXd u_start_;
  JointRun run_;
  SparseCholesky factor_;
};

}  // namespace

Result<JointSolution> solve_jointly(const LayeredMesh& mesh, const Scene& scene,
                                    const JointStart& start, const JointOptions& options,
                                    const RunContext& context) {
  assert(start.inflation.u.size() == mesh.node_vertex.size());
  assert(static_cast<int>(scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  JointModel model = make_joint_model(mesh, scene, start.inflation, options.epsilon);
  model.lambda_bnd = options.lambda_bnd;
  model.lambda_shift = options.lambda_shift;
  const double scale = model.metric.scale;
  JointRounds rounds(mesh, options, context, std::move(model), start);

  JointSolution solution;
  const auto solve = [&](const std::vector<DepthPair>& pairs, Ordering& ordering) {
    return rounds.solve(pairs, ordering, solution);
  };
  Result<Ordering> ordering = order_in_rounds(mesh, scene, scale, options.max_rounds, solve);
  if (!ordering) return ordering.error();
  finish_ordering(mesh, scene, solution.inflation, *ordering);
  for (JointSnapshot& snapshot : solution.snapshots)
    finish_ordering(mesh, scene, snapshot.inflation, snapshot.ordering);
  solution.ordering = std::move(*ordering);
  solution.report = rounds.report(solution.ordering);
  solution.memory = rounds.memory();
  context.report("nonlinear", 1);
  return solution;
}

}  // namespace relievo

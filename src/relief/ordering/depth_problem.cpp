#include "relief/ordering/depth_problem.h"

#include <algorithm>
#include <utility>

#include "kernel/base/piece_timer.h"
#include "kernel/operators/laplacian.h"

namespace relievo {

using Eigen::VectorXd;

namespace {

int count(const std::vector<uint8_t>& flags) {
  return static_cast<int>(std::count(flags.begin(), flags.end(), 1));
}

}  // namespace

DepthProblem make_depth_problem(const std::vector<int>& node_part,
                                const std::vector<DepthPair>& pairs) {
  DepthProblem problem;
  problem.forest = build_depth_forest(node_part, pairs);
  problem.variables = make_gap_variables(problem.forest);
  return problem;
}

VectorXd root_heights(const DepthProblem& problem, const VectorXd& f) {
  VectorXd heights = f;
  for (const DepthGap& gap : problem.forest.gaps) heights[gap.child] = 0;
  return heights;
}

VectorXd beyond_roots(const DepthProblem& problem, const VectorXd& f) {
  return f - problem.variables.T * root_heights(problem, f);
}

std::vector<uint8_t> closed_gaps(const DepthProblem& problem, const std::vector<double>& h) {
  std::vector<uint8_t> closed(problem.variables.bounded.size(), 0);
  for (const DepthGap& gap : problem.forest.gaps)
    closed[gap.child] = gap.sign * (h[gap.child] - h[gap.parent]) <= 0;
  return closed;
}

std::vector<double> heights_of(const DepthProblem& problem, const VectorXd& root_height,
                               const VectorXd& unknowns, double scale) {
  VectorXd shifted = root_height;
  for (int n = 0; n < shifted.size(); ++n)
    if (problem.variables.is_root(n)) shifted[n] += unknowns[n] / scale;
  return heights_from_gaps(problem.forest, shifted, unknowns, 1 / scale);
}

void set_problem(DepthProblem problem, const ShiftMetric& metric, DepthSystem& system) {
  system.qp.K = galerkin_lower(metric.A, problem.variables.T);
  system.qp.bounded = problem.variables.bounded;
  system.qp.fixed = problem.variables.fixed;
  system.problem = std::move(problem);
  system.closed.clear();
  system.factorised = false;
}

DepthSystem make_depth_system(DepthProblem problem, const ShiftMetric& metric,
                              const std::vector<int>& elimination, SparseCholesky factor,
                              const RunContext& context) {
  DepthSystem system;
  system.factor = std::move(factor);
  PieceTimer assembling(context, "assemble");
  set_problem(std::move(problem), metric, system);
  assembling.stop();
  if (context.cancelled()) return system;
  const PieceTimer analysing(context, "analyse");
  system.factor.analyse(system.qp.K, Refactorisation::incremental, elimination, context);
  return system;
}

SolveStatus solve_heights(DepthSystem& system, const ShiftMetric& metric, const VectorXd& f,
                          Ordering& ordering, const RunContext& context) {
  if (context.cancelled()) return SolveStatus::interrupted;
  const DepthProblem& problem = system.problem;
  const GapVariables& variables = problem.variables;
  const VectorXd rest = metric.scale * beyond_roots(problem, f);
  const VectorXd force = metric.A * rest + metric.lean.pull;
  system.qp.b = variables.T.transpose() * force;
  BoundQpOptions options;
  options.start_active = system.closed;
  options.same_matrix = system.factorised;
  options.sweep = std::move(system.sweep);
  BoundQpSolution solution = solve_bound_qp(system.qp, system.factor, std::move(options), context);
  ordering.h = heights_of(problem, root_heights(problem, f), solution.z, metric.scale);
  ordering.equalities = count(variables.fixed);
  ordering.inequalities = count(variables.bounded);
  ordering.report = solution.report;
  ordering.report.energy += 0.5 * (rest.dot(force) + metric.lean.rest(-rest));
  system.closed = std::move(solution.active);
  system.sweep = std::move(solution.sweep);
  system.factorised = solution.report.factorisations > 0;
  return solution.report.status;
}

}  // namespace relievo

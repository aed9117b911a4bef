#include "relief/ordering/depth_problem.h"

#include <algorithm>
#include <utility>

#include "kernel/base/piece_timer.h"
#include "kernel/operators/laplacian.h"

namespace relievo {

using Eigen::VectorXd;

DepthProblem make_depth_problem(const std::vector<int>& node_part,
                                const std::vector<DepthPair>& pairs) {
  DepthProblem problem;
  problem.forest = build_depth_forest(node_part, pairs);
  problem.variables = make_gap_variables(problem.forest);
  return problem;
}

VectorXd root_heights(const DepthProblem& problem, const VectorXd& f) {
  const GapVariables& variables = problem.variables;
  VectorXd heights = VectorXd::Zero(static_cast<Eigen::Index>(variables.bounded.size()));
  for (size_t n = 0; n < problem.forest.representative.size(); ++n) {
    const int v = variables.variable[n];
    if (problem.forest.representative[n] == static_cast<int>(n) && variables.bounded[v] == 0)
      heights[v] = f[static_cast<Eigen::Index>(n)];
  }
  return heights;
}

std::vector<uint8_t> closed_gaps(const DepthProblem& problem, const std::vector<double>& h) {
  std::vector<uint8_t> closed(problem.variables.bounded.size(), 0);
  for (const DepthGap& gap : problem.forest.gaps)
    closed[problem.variables.variable[gap.child]] = gap.sign * (h[gap.child] - h[gap.parent]) <= 0;
  return closed;
}

std::vector<double> heights_of(const DepthProblem& problem, const VectorXd& root_height,
                               const VectorXd& unknowns, double scale) {
  VectorXd shifted = root_height;
  for (Eigen::Index v = 0; v < shifted.size(); ++v)
    if (problem.variables.bounded[v] == 0) shifted[v] += unknowns[v] / scale;
  return heights_from_gaps(problem.forest, problem.variables, shifted, unknowns, 1 / scale);
}

std::vector<int> order_of_variables(const GapVariables& variables,
                                    const std::vector<int>& elimination) {
  std::vector<uint8_t> seen(variables.bounded.size(), 0);
  std::vector<int> order;
  order.reserve(seen.size());
  for (const int n : elimination) {
    const int v = variables.variable[n];
    if (seen[v] == 0) order.push_back(v);
    seen[v] = 1;
  }
  return order;
}

DepthSystem make_depth_system(const DepthProblem& problem, const ShiftMetric& metric,
                              const std::vector<int>& elimination, SparseCholesky factor,
                              const RunContext& context) {
  DepthSystem system{problem, {}, std::move(factor), {}};
  PieceTimer assembling(context, "assemble");
  system.qp.K = galerkin_lower(metric.A, problem.variables.T);
  system.qp.bounded = problem.variables.bounded;
  assembling.stop();
  if (context.cancelled()) return system;
  const PieceTimer analysing(context, "analyse");
  system.factor.analyse(system.qp.K, Refactorisation::incremental,
                        order_of_variables(problem.variables, elimination), context);
  return system;
}

SolveStatus solve_heights(DepthSystem& system, const ShiftMetric& metric, const VectorXd& f,
                          Ordering& ordering, const RunContext& context) {
  if (context.cancelled()) return SolveStatus::interrupted;
  const DepthProblem& problem = system.problem;
  const GapVariables& variables = problem.variables;
  const VectorXd root_height = root_heights(problem, f);
  const VectorXd rest = metric.scale * (f - variables.T * root_height);
  const VectorXd force = metric.A * rest + metric.lean.pull;
  system.qp.b = variables.T.transpose() * force;
  BoundQpOptions options;
  options.start_active = system.closed;
  options.same_matrix = system.factorised;
  const BoundQpSolution solution = solve_bound_qp(system.qp, system.factor, options, context);
  ordering.h = heights_of(problem, root_height, solution.z, metric.scale);
  ordering.equalities = static_cast<int>(ordering.h.size() - variables.bounded.size());
  ordering.inequalities =
      static_cast<int>(std::count(system.qp.bounded.begin(), system.qp.bounded.end(), 1));
  ordering.report = solution.report;
  ordering.report.energy += 0.5 * (rest.dot(force) + metric.lean.rest(-rest));
  system.closed = std::move(solution.active);
  system.factorised = solution.report.factorisations > 0;
  return solution.report.status;
}

}  // namespace relievo

#include "relief/ordering/depth_problem.h"

#include "kernel/base/piece_timer.h"
#include "kernel/operators/laplacian.h"
#include "kernel/solvers/bound_qp.h"

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

SolveStatus solve_heights(const DepthProblem& problem, const ShiftMetric& metric, const VectorXd& f,
                          const std::vector<uint8_t>& start_active, SparseCholesky& factor,
                          Ordering& ordering, const RunContext& context) {
  PieceTimer assembling(context, "assemble");
  const GapVariables& variables = problem.variables;
  const VectorXd root_height = root_heights(problem, f);
  const VectorXd rest = metric.scale * (f - variables.T * root_height);
  const VectorXd force = metric.A * rest;
  const BoundQp qp{galerkin_lower(metric.A, variables.T), variables.T.transpose() * force,
                   variables.bounded};
  assembling.stop();
  if (context.cancelled()) return SolveStatus::interrupted;
  PieceTimer analysing(context, "analyse");
  factor.analyse(qp.K, Refactorisation::incremental);
  analysing.stop();
  BoundQpOptions options;
  options.start_active = start_active;
  const BoundQpSolution solution = solve_bound_qp(qp, factor, options, context);

  ordering.h = heights_of(problem, root_height, solution.z, metric.scale);
  ordering.equalities = static_cast<int>(ordering.h.size() - variables.bounded.size());
  ordering.inequalities = static_cast<int>(problem.forest.gaps.size());
  ordering.report = solution.report;
  ordering.report.energy += 0.5 * rest.dot(force);
  return solution.report.status;
}

}  // namespace relievo

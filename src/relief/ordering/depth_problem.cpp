#include "relief/ordering/depth_problem.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "kernel/base/stopwatch.h"
#include "kernel/operators/laplacian.h"

namespace relievo::relief {
namespace {

/// Where the entries of T are: those of column n are in the rows of n's group, ascending.
struct GroupPattern {
  std::vector<int> place;  ///< #N: of the node in its group
  std::vector<int> size;   ///< #N: of the group, at its smallest node
};

GroupPattern pattern_of(const std::vector<int>& group) {
  GroupPattern pattern;
  pattern.size.assign(group.size(), 0);
  pattern.place.reserve(group.size());
  for (const int smallest : group) pattern.place.push_back(pattern.size[smallest]++);
  return pattern;
}

/// T with all its entries 0.
SparseMatrix empty_matrix(const std::vector<int>& group, const GroupPattern& pattern) {
  const auto nodes = static_cast<int>(group.size());
  SparseMatrix T(nodes, nodes);
  int* begin = T.outerIndexPtr();
  for (int n = 0; n < nodes; ++n) begin[n + 1] = begin[n] + pattern.size[group[n]];
  T.resizeNonZeros(begin[nodes]);
  // All columns of a group have the same rows: each node writes itself into the first one, and the
  // others copy it once it is complete.
  for (int n = 0; n < nodes; ++n) T.innerIndexPtr()[begin[group[n]] + pattern.place[n]] = n;
  for (int n = 0; n < nodes; ++n)
    for (int i = 0; i < pattern.size[group[n]]; ++i)
      T.innerIndexPtr()[begin[n] + i] = T.innerIndexPtr()[begin[group[n]] + i];
  T.coeffs().setZero();
  return T;
}

}  // namespace

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
  BoundQpSolution solution = solve_bound_qp(system.qp, system.factor, std::move(options), context);
  ordering.h = heights_of(problem, root_heights(problem, f), solution.z, metric.scale);
  ordering.equalities = count(variables.fixed);
  ordering.inequalities = count(variables.bounded);
  ordering.report = solution.report;
  ordering.report.energy += 0.5 * (rest.dot(force) + metric.lean.rest(-rest));
  system.closed = std::move(solution.active);
  return solution.report.status;
}

GapVariables make_gap_variables(const DepthForest& forest) {
  const size_t nodes = forest.group.size();
  GapVariables result;
  result.bounded.assign(nodes, 0);
  result.fixed.assign(nodes, 0);
  std::vector<int> parent(nodes, -1);
  std::vector<double> sign(nodes, 1);
  for (const DepthGap& gap : forest.gaps) {
    (gap.equal ? result.fixed : result.bounded)[gap.child] = 1;
    parent[gap.child] = gap.parent;
    sign[gap.child] = gap.sign;
  }
  const GroupPattern pattern = pattern_of(forest.group);
  result.T = empty_matrix(forest.group, pattern);
  for (size_t n = 0; n < nodes; ++n)
    for (int on_way = static_cast<int>(n); on_way >= 0; on_way = parent[on_way])
      result.T.valuePtr()[result.T.outerIndexPtr()[on_way] + pattern.place[n]] = sign[on_way];
  return result;
}

std::vector<double> heights_from_gaps(const DepthForest& forest, const Eigen::VectorXd& root_height,
                                      const Eigen::VectorXd& z, double unit) {
  std::vector<double> height(root_height.begin(), root_height.end());
  for (const DepthGap& gap : forest.gaps)
    height[gap.child] = height[gap.parent] + gap.sign * (z[gap.child] * unit);
  return height;
}

}  // namespace relievo::relief

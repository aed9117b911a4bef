#include "relief/ordering/order_depth.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "kernel/base/piece_timer.h"
#include "kernel/operators/gradient.h"
#include "kernel/operators/laplacian.h"
#include "kernel/solvers/bound_qp.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/layers/joined_surface.h"
#include "relief/ordering/depth_forest.h"
#include "relief/ordering/gap_variables.h"
#include "relief/ordering/overlap.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// Crossings shallower than this are round-off; scene units.
constexpr double crossing_tolerance = 1e-9;

/// 1/2 (h - f)' A (h - f) in scene units; f also in px.
struct ShiftEnergy {
  double scale = 1;  ///< scene units per px
  SparseMatrix A;    ///< L + epsilon M
  VectorXd f;        ///< #N, px
};

ShiftEnergy make_energy(const LayeredMesh& mesh, const Inflation& inflation, double epsilon) {
  ShiftEnergy energy;
  energy.scale = scene_scale(mesh);
  const std::vector<Point2> positions = node_positions(mesh, energy.scale);
  const FlatMesh flat{positions, mesh.faces};
  energy.A = stiffness_matrix(flat);
  energy.A.diagonal() += epsilon * lumped_mass(flat);
  energy.f.resize(static_cast<Eigen::Index>(inflation.u.size()));
  for (Eigen::Index n = 0; n < energy.f.size(); ++n)
    energy.f[n] = std::copysign(std::sqrt(std::abs(inflation.u[n])), inflation.u[n]);
  return energy;
}

/// The gaps to start from: closed where the last heights leave none.
std::vector<uint8_t> closed_gaps(const DepthForest& forest, const GapVariables& variables,
                                 const std::vector<double>& h) {
  std::vector<uint8_t> closed(variables.bounded.size(), 0);
  for (const DepthGap& gap : forest.gaps)
    closed[variables.variable[gap.child]] = gap.sign * (h[gap.child] - h[gap.parent]) <= 0;
  return closed;
}

/// Solves for the heights under given pairs. The unknowns are the shift of each root and the gaps;
/// counting from f keeps them small, and exactly 0 where nothing pushes.
class DepthSolver {
 public:
  DepthSolver(const ShiftEnergy& energy, const std::vector<int>& node_part, bool start_active)
      : energy_(energy), node_part_(node_part), start_active_(start_active) {}

  /// Writes h and the counts and report of `ordering`; its former h is the first guess.
  SolveStatus solve(const std::vector<DepthPair>& pairs, Ordering& ordering,
                    const RunContext& context) {
    PieceTimer assembling(context, "assemble");
    const DepthForest forest = build_depth_forest(node_part_, pairs);
    const GapVariables variables = make_gap_variables(forest);
    const VectorXd root_height = root_heights(forest, variables);
    const VectorXd rest = energy_.scale * (energy_.f - variables.T * root_height);
    const VectorXd force = energy_.A * rest;

    BoundQp problem{galerkin_lower(energy_.A, variables.T), variables.T.transpose() * force,
                    variables.bounded};
    assembling.stop();
    if (context.cancelled()) return SolveStatus::interrupted;
    PieceTimer analysing(context, "analyse");
    factor_.analyse(problem.K, Refactorisation::incremental);
    analysing.stop();
    const BoundQpSolution solution =
        solve_bound_qp(problem, factor_, first_guess(forest, variables, ordering.h), context);

    const double px = 1 / energy_.scale;
    VectorXd shifted = root_height;
    for (Eigen::Index v = 0; v < shifted.size(); ++v)
      if (variables.bounded[v] == 0) shifted[v] += px * solution.z[v];
    ordering.h = heights_from_gaps(forest, variables, shifted, solution.z, px);
    ordering.equalities = static_cast<int>(ordering.h.size() - variables.bounded.size());
    ordering.inequalities = static_cast<int>(forest.gaps.size());
    ordering.report = solution.report;
    ordering.report.energy += 0.5 * rest.dot(force);
    return solution.report.status;
  }

 private:
  /// f at the roots and 0 at the gaps, px.
  VectorXd root_heights(const DepthForest& forest, const GapVariables& variables) const {
    VectorXd heights = VectorXd::Zero(static_cast<Eigen::Index>(variables.bounded.size()));
    for (size_t n = 0; n < forest.representative.size(); ++n) {
      const int v = variables.variable[n];
      if (forest.representative[n] == static_cast<int>(n) && variables.bounded[v] == 0)
        heights[v] = energy_.f[static_cast<Eigen::Index>(n)];
    }
    return heights;
  }

  BoundQpOptions first_guess(const DepthForest& forest, const GapVariables& variables,
                             const std::vector<double>& h) const {
    BoundQpOptions options;
    if (!h.empty())
      options.start_active = closed_gaps(forest, variables, h);
    else if (start_active_)
      options.start_active = variables.bounded;
    return options;
  }

  const ShiftEnergy& energy_;
  const std::vector<int>& node_part_;
  bool start_active_;
  SparseCholesky factor_;  ///< kept for its memory
};

Status check_options(const OrderingOptions& options) {
  if (!(options.epsilon > 0 && std::isfinite(options.epsilon)))
    return Error{ErrorCode::usage, "epsilon must be positive", "epsilon"};
  if (options.max_rounds < 0)
    return Error{ErrorCode::usage, "the number of rounds must not be negative", "max_rounds"};
  return Done{};
}

Status check_solved(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return Done{};
    case SolveStatus::interrupted:
      return interrupted_error();
    case SolveStatus::iteration_limit:
      return Error{ErrorCode::limit, "the depth order took too many iterations", ""};
    case SolveStatus::not_positive_definite:
      break;
  }
  return Error{ErrorCode::internal, "the depth order has no finite solution", ""};
}

double worst_violation(const std::vector<DepthPair>& pairs, const std::vector<double>& h) {
  double worst = 0;
  for (const DepthPair& pair : pairs) {
    const double violation = h[pair.lower] - h[pair.upper];
    worst = std::max(worst, pair.equal ? std::abs(violation) : violation);
  }
  return worst;
}

/// Solves, adds the interior nodes that cross as pairs and repeats.
Status solve_in_rounds(const LayeredMesh& mesh, const std::vector<FacePair>& stacked,
                       const ShiftEnergy& energy, const OrderingOptions& options,
                       const RunContext& context, Ordering& ordering) {
  DepthSolver solver(energy, mesh.node_part, options.start_active);
  std::vector<DepthPair> pairs = mesh.constraints;
  for (;;) {
    context.report("order", ordering.rounds / (options.max_rounds + 1.0));
    if (Status status = check_solved(solver.solve(pairs, ordering, context)); !status)
      return status;
    if (ordering.rounds == options.max_rounds) break;
    const std::vector<DepthPair> crossed =
        crossed_nodes(mesh, stacked, ordering.h, crossing_tolerance / energy.scale);
    if (crossed.empty()) break;
    ++ordering.rounds;
    ordering.interior_pairs += static_cast<int>(crossed.size());
    pairs.insert(pairs.end(), crossed.begin(), crossed.end());
  }
  ordering.max_violation = worst_violation(pairs, ordering.h);
  return Done{};
}

}  // namespace

Result<Ordering> order_depth(const LayeredMesh& mesh, const Inflation& inflation,
                             const Scene& scene, const OrderingOptions& options,
                             const RunContext& context) {
  assert(inflation.u.size() == mesh.node_vertex.size());
  assert(static_cast<int>(scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  PieceTimer assembling(context, "assemble");
  const ShiftEnergy energy = make_energy(mesh, inflation, options.epsilon);
  assembling.stop();
  const std::vector<FacePair> stacked = stacked_faces(mesh, scene);
  Ordering ordering;
  if (Status status = solve_in_rounds(mesh, stacked, energy, options, context, ordering); !status)
    return status.error();

  ordering.g.reserve(ordering.h.size());
  for (size_t n = 0; n < ordering.h.size(); ++n)
    ordering.g.push_back(ordering.h[n] - energy.f[static_cast<Eigen::Index>(n)]);
  const std::vector<Point2> positions = node_positions(mesh);
  ordering.grad_g = node_gradients({positions, mesh.faces}, ordering.g);
  const OverlapSamples samples =
      sample_overlap(mesh, stacked, inflation.u, ordering.g, crossing_tolerance / energy.scale);
  ordering.overlap_samples = samples.count;
  ordering.overlap_worst = samples.worst;
  context.report("order", 1);
  return ordering;
}

}  // namespace relievo

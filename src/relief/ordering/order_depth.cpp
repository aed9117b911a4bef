#include "relief/ordering/order_depth.h"

#include <cassert>

#include "kernel/base/piece_timer.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/ordering/depth_problem.h"
#include "relief/ordering/order_rounds.h"

namespace relievo {
namespace {

/// The gaps to start from: those that the last round closed, or as the options say.
std::vector<uint8_t> first_guess(const DepthProblem& problem, const std::vector<double>& last_h,
                                 bool start_active) {
  if (!last_h.empty()) return closed_gaps(problem, last_h);
  return start_active ? problem.variables.bounded : std::vector<uint8_t>();
}

}  // namespace

Result<Ordering> order_depth(const LayeredMesh& mesh, const Inflation& inflation,
                             const Scene& scene, const OrderingOptions& options,
                             const RunContext& context) {
  assert(inflation.u.size() == mesh.node_vertex.size());
  assert(static_cast<int>(scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  PieceTimer assembling(context, "assemble");
  const ShiftMetric metric = make_shift_metric(mesh, options.epsilon);
  assembling.stop();
  const Eigen::VectorXd f = inflated_heights(inflation.u);
  SparseCholesky factor;
  const auto solve = [&](const std::vector<DepthPair>& pairs, Ordering& ordering) {
    context.report("order", ordering.rounds / (options.max_rounds + 1.0));
    PieceTimer sorting(context, "assemble");
    const DepthProblem problem = make_depth_problem(mesh.node_part, pairs);
    sorting.stop();
    const std::vector<uint8_t> closed = first_guess(problem, ordering.h, options.start_active);
    return check_solved(solve_heights(problem, metric, f, closed, factor, ordering, context));
  };
  Result<Ordering> ordering = order_in_rounds(mesh, scene, metric.scale, options.max_rounds, solve);
  if (!ordering) return ordering;
  finish_ordering(mesh, scene, inflation, *ordering);
  context.report("order", 1);
  return ordering;
}

}  // namespace relievo

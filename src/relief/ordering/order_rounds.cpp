#include "relief/ordering/order_rounds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "kernel/base/workers.h"
#include "relief/ordering/overlap.h"
#include "relief/ordering/shift_metric.h"

namespace relievo {
namespace {

/// Where crossing nodes are added, so many rings around them are too: small changes then need no
/// others.
constexpr int margin = 2;
/// Stacked nodes are all compared where they are at most one of so many nodes: then one matrix does
/// for all rounds and edits. Gaps in deeper stacks would make it too dense, as they couple sheets.
constexpr size_t affordable_share = 2;

double worst_violation(const std::vector<DepthPair>& pairs, const std::vector<double>& h) {
  double worst = 0;
  for (const DepthPair& pair : pairs) {
    const double violation = h[pair.lower] - h[pair.upper];
    worst = std::max(worst, pair.equal ? std::abs(violation) : violation);
  }
  return worst;
}

/// The pairs of the mesh and those of stacked nodes.
std::vector<DepthPair> with_inside(const LayeredMesh& mesh, const std::vector<DepthPair>& inside) {
  std::vector<DepthPair> pairs = mesh.constraints;
  pairs.insert(pairs.end(), inside.begin(), inside.end());
  return pairs;
}

/// Clears the flags that are set in `known`; whether any are left.
bool exclude(const std::vector<uint8_t>& known, std::vector<uint8_t>& flags) {
  bool any = false;
  for (size_t i = 0; i < flags.size(); ++i) {
    flags[i] &= static_cast<uint8_t>(known[i] == 0);
    any = any || flags[i] != 0;
  }
  return any;
}

void include(const std::vector<uint8_t>& added, std::vector<uint8_t>& flags) {
  for (size_t i = 0; i < flags.size(); ++i) flags[i] |= added[i];
}

}  // namespace

RoundPlan plan_rounds(const StackedNodes& stacked, const std::vector<DepthPair>& known,
                      size_t nodes, int max_rounds) {
  RoundPlan plan{stacked, {}, margin, max_rounds};
  if (max_rounds == 0) return plan;
  plan.inside = stacked.pairs.size() <= nodes / affordable_share ? stacked.pairs : known;
  return plan;
}

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

std::vector<DepthPair> first_pairs(const LayeredMesh& mesh, const RoundPlan& plan) {
  return with_inside(mesh, flagged(plan.stacked, flags_of(plan.stacked, plan.inside)));
}

Result<Ordering> order_in_rounds(const LayeredMesh& mesh, double scale, RoundPlan& plan,
                                 const HeightSolver& solve) {
  std::vector<uint8_t> chosen = flags_of(plan.stacked, plan.inside);
  std::vector<DepthPair> pairs;
  Ordering ordering;
  for (;;) {
    plan.inside = flagged(plan.stacked, chosen);
    pairs = with_inside(mesh, plan.inside);
    ordering.interior_pairs = static_cast<int>(plan.inside.size());
    if (Status status = solve(pairs, ordering); !status) return status.error();
    if (ordering.rounds == plan.max_rounds) break;
    std::vector<uint8_t> added = crossed(plan.stacked, ordering.h, crossing_tolerance / scale);
    if (!exclude(chosen, added)) break;
    ++ordering.rounds;
    include(grown(plan.stacked, std::move(added), plan.margin), chosen);
  }
  ordering.max_violation = worst_violation(pairs, ordering.h);
  return ordering;
}

void finish_ordering(const OrderingInput& input, const std::vector<FacePair>& stacked,
                     Ordering& ordering) {
  const Eigen::VectorXd f = inflated_heights(input.inflation.u);
  ordering.g.clear();
  ordering.g.reserve(ordering.h.size());
  for (size_t n = 0; n < ordering.h.size(); ++n)
    ordering.g.push_back(ordering.h[n] - f[static_cast<Eigen::Index>(n)]);
  const CreaseStencils& creases = input.discretisation.creases;
  ordering.creases = {creases.corner, crease_gradients(creases, ordering.g)};
  OverlapSamples samples;
  run_tasks(2, [&](int task) {
    if (task == 0)
      ordering.grad_g = node_gradients(input.discretisation.gradients, ordering.g);
    else
      samples = sample_overlap(input.mesh, stacked, input.inflation.u, ordering.g,
                               crossing_tolerance / input.discretisation.scale);
  });
  ordering.overlap_samples = samples.count;
  ordering.overlap_worst = samples.worst;
}

}  // namespace relievo

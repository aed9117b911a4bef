#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/order_depth.h"
#include "relief/ordering/ordering.h"
#include "relief/ordering/stacked_nodes.h"
#include "relief/scene/scene.h"

namespace relievo {

/// Crossings shallower than this are round-off; scene units.
constexpr double crossing_tolerance = 1e-9;

/// Finds heights under the given pairs: writes h, the counts and the report of an ordering that
/// holds the heights of the last round, if any.
using HeightSolver = std::function<Status(const std::vector<DepthPair>& pairs, Ordering& ordering)>;

/// Which stacked nodes are compared, and how that grows.
struct RoundPlan {
  const StackedNodes& stacked;
  std::vector<DepthPair> inside;  ///< pairs compared from the first round on, then all, sorted
  int margin = 0;                 ///< rings of pairs around crossing ones that are added with them
  int max_rounds = 0;
};

/// Compares all stacked nodes from the first round on where that is affordable, else `known` ones;
/// none where there is only one round.
RoundPlan plan_rounds(const StackedNodes& stacked, const std::vector<DepthPair>& known,
                      size_t nodes, int max_rounds);

Status check_options(const OrderingOptions& options);

/// The error, if any, that a status of the solver stands for.
Status check_solved(SolveStatus status);

/// The pairs of the first round. O(N).
std::vector<DepthPair> first_pairs(const LayeredMesh& mesh, const RoundPlan& plan);

/// Solves under the pairs of the mesh and those of the plan, adds stacked nodes that cross and
/// repeats at most `max_rounds` times. More pairs than necessary do not change the minimum, for
/// without them nothing crosses either. `scale`: scene units per px.
Result<Ordering> order_in_rounds(const LayeredMesh& mesh, double scale, RoundPlan& plan,
                                 const HeightSolver& solve);

/// Fills in g = h - f, its gradients and the samples of the overlap of `stacked` faces.
void finish_ordering(const OrderingInput& input, const std::vector<FacePair>& stacked,
                     Ordering& ordering);

}  // namespace relievo

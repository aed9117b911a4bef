#pragma once

#include <functional>
#include <vector>

#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/order_depth.h"
#include "relief/ordering/ordering.h"
#include "relief/scene/scene.h"

namespace relievo {

/// Crossings shallower than this are round-off; scene units.
constexpr double crossing_tolerance = 1e-9;

/// Finds heights under the given pairs: writes h, the counts and the report of an ordering that
/// holds the heights of the last round, if any.
using HeightSolver = std::function<Status(const std::vector<DepthPair>& pairs, Ordering& ordering)>;

Status check_options(const OrderingOptions& options);

/// The error, if any, that a status of the solver stands for.
Status check_solved(SolveStatus status);

/// Solves under the pairs of the mesh, adds interior nodes that cross as pairs and repeats at most
/// `max_rounds` times. `scale`: scene units per px.
Result<Ordering> order_in_rounds(const LayeredMesh& mesh, const Scene& scene, double scale,
                                 int max_rounds, const HeightSolver& solve);

/// Fills in g = h - f, its gradients and the samples of the overlap.
void finish_ordering(const OrderingInput& input, Ordering& ordering);

/// The same with operators for one use.
void finish_ordering(const LayeredMesh& mesh, const Scene& scene, const Inflation& inflation,
                     Ordering& ordering);

}  // namespace relievo

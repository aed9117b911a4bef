#pragma once

#include "kernel/geometry/polygon.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relief/ordering/ordering_system.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Makes the matrix of order_depth and its analysis, which do not depend on the inflation, so that
/// both can run at the same time. Optional, and of no effect on the result.
void prepare_ordering(const SurfaceInput& surface, const OrderingOptions& options,
                      OrderingSystem& system, const RunContext& context = {});

/// Shifts the parts so that all depth pairs of the mesh hold, at the least cost of g (ShiftMetric):
/// its Dirichlet energy, or that of its difference from wanted shifts. `system` is new or was used
/// with the same discretisation before. Then the solver starts from the last active set and
/// computes only what has changed; the minimum is the same. Fails with usage for options out of
/// range, with limit or internal if the solver fails, and when cancelled.
Result<Ordering> order_depth(const SurfaceInput& surface, const Inflation& inflation,
                             const OrderingOptions& options, OrderingSystem& system,
                             const RunContext& context = {});

/// Makes the discretisation and the system, and solves once.
Result<Ordering> order_depth(const LayeredMesh& mesh, const Inflation& inflation,
                             const Scene& scene, const OrderingOptions& options,
                             const RunContext& context = {});

Status check_options(const OrderingOptions& options);

/// Returns the error that a status of the solver stands for, if any.
Status check_solved(SolveStatus status);

/// Computes g = h - f, its gradients and the worst violation of the mesh's pairs from h.
/// O(N + pairs).
void finish_ordering(const SurfaceInput& surface, const Inflation& inflation, Ordering& ordering);

}  // namespace relievo::relief

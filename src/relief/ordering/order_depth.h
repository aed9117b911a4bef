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

struct OrderingOptions {
  double epsilon = 1e-4;      ///< weight of the pull to h = f, in scene units (box diagonal 2)
  bool start_active = false;  ///< first guess of the active set: all gaps closed, or none
  WantedShifts wanted = {};
};

/// The joined surface and what was computed of it.
struct OrderingInput {
  const LayeredMesh& mesh;
  const Discretisation& discretisation;
  const Inflation& inflation;
  const Scene& scene;
};

/// Does the part of order_depth that the inflation does not enter, its matrix and the analysis of
/// it, so that both can go on at the same time. Not needed, and of no effect on the result.
void prepare_ordering(const SurfaceInput& surface, const OrderingOptions& options,
                      OrderingSystem& system, const RunContext& context = {});

/// Shifts the parts so that all depth pairs of the mesh hold, by the least Dirichlet energy of g,
/// or of what distinguishes it from the leans of parts (ShiftMetric). `system` is a new one or was
/// used for the same discretisation before: then the solver begins from what it found, and computes
/// again only what is different. Its minimum is the same.
Result<Ordering> order_depth(const OrderingInput& input, const OrderingOptions& options,
                             OrderingSystem& system, const RunContext& context = {});

/// The same with operators and a system for one use.
Result<Ordering> order_depth(const LayeredMesh& mesh, const Inflation& inflation,
                             const Scene& scene, const OrderingOptions& options,
                             const RunContext& context = {});

Status check_options(const OrderingOptions& options);

/// The error, if any, that a status of the solver stands for.
Status check_solved(SolveStatus status);

/// Fills in g = h - f, its gradients and the worst violation of the mesh's pairs. O(N + pairs).
void finish_ordering(const OrderingInput& input, Ordering& ordering);

}  // namespace relievo::relief

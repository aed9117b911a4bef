#pragma once

#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relief/scene/scene.h"

namespace relievo {

struct OrderingOptions {
  double epsilon = 1e-4;      ///< weight of the pull to h = f, in scene units (box diagonal 2)
  int max_rounds = 3;         ///< cutting-plane rounds for interior overlap
  bool start_active = false;  ///< first guess of the active set: all gaps closed, or none
};

/// Shifts the parts so that all depth pairs hold, by the least Dirichlet energy of g.
Result<Ordering> order_depth(const LayeredMesh& mesh, const Inflation& inflation,
                             const Scene& scene, const OrderingOptions& options,
                             const RunContext& context = {});

}  // namespace relievo

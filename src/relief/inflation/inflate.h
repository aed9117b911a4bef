#pragma once

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/inflation/poisson_system.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

struct InflationOptions {
  double alpha0 = 0;  ///< alpha beside a join's end, in [0, 1]; 1 gives the paper's pits
  double rho = 0.25;  ///< length scale of a ramp / its length, > 0
};

/// The joined surface and what was computed of it.
struct InflationInput {
  const LayeredMesh& mesh;
  const Discretisation& discretisation;
  const Scene& scene;
};

/// Fails with bad_input where a surface has no outline that holds it at 0, naming its part. O(F).
Status check_held(const LayeredMesh& mesh, const Scene& scene, const InflationOptions& options);

/// Solves (L + B_beta + K) u = M c once for all parts, K the screening of flat ones. Fails as
/// check_held. `system` is that of the mesh and its discretisation; the result does not depend on
/// what it was used for before.
Result<Inflation> inflate(const InflationInput& input, const InflationOptions& options,
                          PoissonSystem& system, const RunContext& context = {});

/// The same with operators and a system for one use.
Result<Inflation> inflate(const LayeredMesh& mesh, const Scene& scene,
                          const InflationOptions& options, const RunContext& context = {});

}  // namespace relievo::relief

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
  double alpha0 = 0;  ///< alpha at the end of a join, in [0, 1]; 1 gives the paper's pits
  double rho = 0.25;  ///< length scale l of a ramp relative to its length, > 0
};

/// Checks that each joined surface has a node with a Dirichlet or Robin condition. Fails with
/// bad_input, naming a part, if one has none: the Poisson problem is singular then. O(F).
Status check_fixed(const LayeredMesh& mesh, const Scene& scene, const InflationOptions& options);

/// Solves (L + B + K) u = M c for all parts at once, and raises bumps. `system` must be made for
/// the mesh and its discretisation; the result does not depend on its earlier use. Fails as
/// check_fixed, with usage for options out of range, and when cancelled.
Result<Inflation> inflate(const SurfaceInput& surface, const InflationOptions& options,
                          PoissonSystem& system, const RunContext& context = {});

/// Adds w = sgn(d) sqrt(v psi^3) to f on every bump and updates the gradients of u. v is the
/// inflation of the part alone, 0 on its outline. psi is harmonic, with the value alpha on the
/// outline: 0 on the join. So the surface crosses the join without a change of slope, and nothing
/// outside the bump moves. Precondition: inflate has accepted the options. O(N) and two
/// factorisations of each bump's nodes.
void raise_bumps(const SurfaceInput& surface, const InflationOptions& options,
                 Inflation& inflation);

}  // namespace relievo::relief

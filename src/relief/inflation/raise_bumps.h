#pragma once

#include "relief/inflation/inflate.h"
#include "relief/inflation/inflation.h"

namespace relievo::relief {

/// Adds w = sgn(d) sqrt(v psi^3) to f on every bump and updates the gradients of u. v is the
/// inflation of the part alone, 0 on its outline. psi is harmonic, with the value alpha on the
/// outline: 0 on the join. So the surface crosses the join without a change of slope, and nothing
/// outside the bump moves. Precondition: inflate has accepted the options. O(N) and two
/// factorisations of each bump's nodes.
void raise_bumps(const SurfaceInput& surface, const InflationOptions& options,
                 Inflation& inflation);

}  // namespace relievo::relief

#pragma once

#include "relief/inflation/inflate.h"
#include "relief/inflation/inflation.h"

namespace relievo::relief {

/// Adds to f on every bump what the part would have by itself, eased off where it is joined:
/// w = sgn(d) sqrt(v psi^3), where v is the part's own inflation (0 on its outline) and psi is
/// harmonic with alpha on the outline (0 on the join). So the surface goes on across the join with
/// its slope, and nothing outside of the bump moves. Gradients of u are those of the sum. Options
/// as for inflate, and checked. O(N) and two factorisations of each bump's nodes.
void raise_bumps(const InflationInput& input, const InflationOptions& options,
                 Inflation& inflation);

}  // namespace relievo::relief

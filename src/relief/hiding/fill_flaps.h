#pragma once

#include "kernel/base/run_context.h"
#include "relief/hiding/hide_sheets.h"

namespace relievo {

/// Gives the nodes inside flaps u and g: the Poisson problem of their part and the smoothest shift
/// that go on from the nodes at their edges, both free along the cut at the join. One factorisation
/// each of the flaps' nodes.
void fill_flaps(const HidingInput& input, HiddenSheets& sheets, const RunContext& context);

}  // namespace relievo

#pragma once

#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "research/rivals/rival.h"

namespace relievo::research {

/// Our own, with its defaults.
Result<Model> reconstruct_ours(const RivalInput& input, const RunContext& context);

/// Our joined surface with u = 0 along the whole outline of the upper part, as in Monster Mash
/// (Dvorožňák et al. 2020): pits where joins end.
Result<Model> reconstruct_with_firm_ends(const RivalInput& input, const RunContext& context);

/// Every part by itself, without joins: what inflating layers one by one gives.
Result<Model> reconstruct_pillows(const RivalInput& input, const RunContext& context);

/// Parts by themselves with the profile of Poisson's equation without the root (Yeh et al. 2017,
/// Jayaraman et al. 2018): f = d u s, s of each part such that its apex is that of d sqrt(u).
Result<Model> reconstruct_parabolic(const RivalInput& input, const RunContext& context);

}  // namespace relievo::research

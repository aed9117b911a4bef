#pragma once

#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "research/rivals/rival.h"

namespace relievo::research {

/// Reconstructs by our method, with its defaults.
Result<Model> reconstruct_ours(const RivalInput& input, const RunContext& context);

/// Reconstructs our joined surface with u = 0 along the whole outline of the upper part, as in
/// Monster Mash (Dvorožňák et al. 2020). It has pits at the ends of joins.
Result<Model> reconstruct_with_firm_ends(const RivalInput& input, const RunContext& context);

/// Inflates every part separately, without joins.
Result<Model> reconstruct_pillows(const RivalInput& input, const RunContext& context);

/// Inflates every part separately, with the parabolic profile of Yeh et al. 2017 and Jayaraman et
/// al. 2018: f = d u s, where s gives each part the apex of d sqrt(u).
Result<Model> reconstruct_parabolic(const RivalInput& input, const RunContext& context);

}  // namespace relievo::research

#pragma once

#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "research/rivals/rival.h"

namespace relievo::research {

/// Ink-and-Ray (Sýkora et al. 2014): parts by themselves with a natural boundary where they join,
/// brought to the height of the lower part there by the depth order, and grafted afterwards.
Result<Model> reconstruct_ink_and_ray(const RivalInput& input, const RunContext& context);

}  // namespace relievo::research

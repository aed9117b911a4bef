#pragma once

#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "research/rivals/rival.h"

namespace relievo::research {

/// Reconstructs by Ink-and-Ray (Sýkora et al. 2014): inflates separate parts with natural
/// boundaries along joins, brings them there to the height of the lower part by the depth order,
/// and grafts.
Result<Model> reconstruct_ink_and_ray(const RivalInput& input, const RunContext& context);

}  // namespace relievo::research

#pragma once

#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "research/rivals/rival.h"

namespace relievo::research {

/// Reconstructs a closed convolution surface over the medial axes of all parts (Entem et al. 2015).
Result<Model> reconstruct_entem(const RivalInput& input, const RunContext& context);

}  // namespace relievo::research

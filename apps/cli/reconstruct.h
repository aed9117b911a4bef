#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/inputs.h"
#include "kernel/base/result.h"
#include "kernel/base/run_context.h"

namespace relievo::cli {

/// The relief of a scene by the chosen options, or the field of it that they ask for. They may
/// change the scene's own values (c).
Result<Relief> reconstruct(Scene& scene, const ReliefArguments& arguments,
                           const RunContext& context);

/// The surface of a relief that the chosen visibility keeps.
Result<Model> make_model(const Relief& relief, const Scene& scene, const ReliefArguments& arguments,
                         const RunContext& context);

}  // namespace relievo::cli

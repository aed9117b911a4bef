#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/inputs.h"
#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "relief/model/drawn_model.h"

namespace relievo::cli {

/// The relief of a scene by the chosen options, or the field of it that they ask for. They may
/// change the scene's own values (c).
Result<Relief> reconstruct(Scene& scene, const ReliefArguments& arguments,
                           const RunContext& context);

/// The surface of a relief that the chosen visibility keeps, with the drawing on it; what is hidden
/// has colours of its own.
Result<DrawnModel> make_model(const Relief& relief, const SceneInput& input,
                              const ReliefArguments& arguments, const RunContext& context);

}  // namespace relievo::cli

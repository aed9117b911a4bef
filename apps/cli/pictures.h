#pragma once

#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "relief/session/build_relief.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::cli {

/// Renders a model as a PNG file, as the arguments specify.
Result<Bytes> draw_picture(const Model& model, const Drawing& drawing,
                           const RenderArguments& arguments, const RunContext& context);

/// Returns the steps after which the surface is shown: 1, 2, 3, 5, 8, ..., up to `last`.
std::vector<int> convergence_steps(int last);

/// Renders the intermediate surfaces of the non-linear method and the final one, in clay, side by
/// side at the same scale, as a PNG file.
Result<Bytes> draw_convergence(const relief::Relief& relief, const Scene& scene,
                               const RunContext& context);

}  // namespace relievo::cli

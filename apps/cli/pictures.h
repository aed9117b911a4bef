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

/// A picture of a model as a PNG file, as the arguments describe it.
Result<Bytes> draw_picture(const Model& model, const Drawing& drawing,
                           const RenderArguments& arguments, const RunContext& context);

/// After which steps the surface is shown: closely at first, then ever farther apart.
std::vector<int> convergence_steps(int last);

/// The surfaces that the non-linear method passed through and the one it ended at, in clay, side
/// by side at one scale, as a PNG file.
Result<Bytes> draw_convergence(const relief::Relief& relief, const Scene& scene,
                               const RunContext& context);

}  // namespace relievo::cli

#pragma once

#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "io/overlay/overlay_svg.h"
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

/// Draws the parts and annotations of a scene over its drawing, as a PNG file. `drawing` is RGBA
/// and covers the canvas; if it is empty, the background is white.
Result<Bytes> draw_overlay(const Scene& scene, const OverlayMarks& marks, const Image8& drawing);

}  // namespace relievo::cli

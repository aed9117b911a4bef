#pragma once

#include <optional>

#include "apps/cli/arguments.h"
#include "face/inputs.h"
#include "relief/model/visible_sheet.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "solid/check_print.h"
#include "solid/make_solid.h"

namespace relievo::cli {

/// A model, and what is to be told of it where it is a solid.
struct MadeModel {
  DrawnModel drawn;
  std::optional<SolidFacts> solid;
  std::vector<PrintFinding> print;
};

/// The options of a relief, and what they change of the scene's own values.
Result<ReliefOptions> settle_options(Scene& scene, const ReliefArguments& arguments);

/// The relief of a scene by the chosen options, or the field of it that they ask for. They may
/// change the scene's own values (c).
Result<Relief> reconstruct(Scene& scene, const ReliefArguments& arguments,
                           const RunContext& context);

/// The solid of a relief where that is asked for; otherwise the surface that the chosen visibility
/// keeps, with the drawing on it, and what is hidden has colours of its own.
Result<MadeModel> make_model(const Relief& relief, const SceneInput& input,
                             const ReliefArguments& arguments, const RunContext& context);

}  // namespace relievo::cli

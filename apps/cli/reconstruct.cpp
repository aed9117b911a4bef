#include "apps/cli/reconstruct.h"

#include <utility>

#include "apps/cli/cue_argument.h"
#include "relief/model/dress_hidden.h"

namespace relievo::cli {

Result<Relief> reconstruct(Scene& scene, const ReliefArguments& arguments,
                           const RunContext& context) {
  if (arguments.c)
    for (Part& part : scene.parts) part.c = *arguments.c;
  if (arguments.flat)
    for (Part& part : scene.parts) part.flat = *arguments.flat;
  if (arguments.lean)
    for (Part& part : scene.parts) part.lean = *arguments.lean;
  if (Status status = add_cues(arguments.cues, scene); !status) return status.error();
  auto relief = build_relief(scene, arguments.options, context);
  if (!relief) return relief;
  keep_field(*relief, arguments.field);
  for (std::string& warning : warnings_about_cues(scene))
    relief->layers.warnings.push_back(std::move(warning));
  return relief;
}

Result<DrawnModel> make_model(const Relief& relief, const SceneInput& input,
                              const ReliefArguments& arguments, const RunContext& context) {
  ModelOptions options;
  options.visibility = arguments.visibility;
  auto model = assemble_model(relief.layers, relief.inflation, relief.ordering, input.scene,
                              options, context);
  if (!model) return model.error();
  return dress_hidden(std::move(*model), input.drawing);
}

}  // namespace relievo::cli

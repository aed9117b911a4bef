#include "apps/cli/reconstruct.h"

#include <utility>

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
  auto relief = build_relief(scene, arguments.options, context);
  if (relief) keep_field(*relief, arguments.field);
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

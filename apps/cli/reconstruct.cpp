#include "apps/cli/reconstruct.h"

namespace relievo::cli {

Result<Relief> reconstruct(Scene& scene, const ReliefArguments& arguments,
                           const RunContext& context) {
  if (arguments.c)
    for (Part& part : scene.parts) part.c = *arguments.c;
  if (arguments.flat)
    for (Part& part : scene.parts) part.flat = *arguments.flat;
  auto relief = build_relief(scene, arguments.options, context);
  if (relief) keep_field(*relief, arguments.field);
  return relief;
}

Result<Model> make_model(const Relief& relief, const Scene& scene, const ReliefArguments& arguments,
                         const RunContext& context) {
  ModelOptions options;
  options.visibility = arguments.visibility;
  return assemble_model(relief.layers, relief.inflation, relief.ordering, scene, options, context);
}

}  // namespace relievo::cli

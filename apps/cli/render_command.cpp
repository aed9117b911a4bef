#include "apps/cli/render_command.h"

#include "apps/cli/cost.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/pictures.h"
#include "apps/cli/reconstruct.h"
#include "face/inputs.h"
#include "io/files/paths.h"
#include "io/mesh/glb_decode.h"

namespace relievo::cli {
namespace {

/// A model to render.
struct Subject {
  relief::DrawnModel drawn;
  std::vector<std::filesystem::path> files;  ///< inputs, never overwritten
};

Result<Subject> load_model(const InputFile& input) {
  auto drawn = decode_glb(input.bytes);
  if (!drawn) return in_file(drawn.error(), input.name);
  Subject subject{std::move(*drawn), {}};
  if (input.name != "-") subject.files.emplace_back(input.name);
  return subject;
}

Result<Subject> build_model(const InputFile& input, const RenderArguments& render,
                            const RunContext& context) {
  if (Status s = check_cost(render.relief.options, render.common.quiet); !s) return s.error();
  auto loaded = load_scene(input, render.common.connect, context);
  if (!loaded) return loaded.error();
  const auto relief = reconstruct(*loaded, render.relief, context);
  print_warnings(loaded->warnings, render.common.quiet);
  if (!relief) return relief.error();
  // Rims are narrowed for the ink of the drawing, which clay does not show.
  if (render.clay && !render.relief.solid) loaded->drawing = {};
  auto drawn = make_model(*relief, *loaded, render.relief, context);
  if (!drawn) return drawn.error();
  return Subject{std::move(drawn->drawn), std::move(loaded->files)};
}

}  // namespace

Status run_render(const RenderArguments& render, Interruption& interruption) {
  if (Status status = check_outputs({render.output}, {render.common.input}); !status) return status;
  const auto input = read_input(render.common.input);
  if (!input) return input.error();
  Progress progress(render.common.quiet);
  RunContext context{interruption.flag()};
  progress.watch(context);
  const auto subject = sniff(input->bytes) == InputKind::glb ? load_model(*input)
                                                             : build_model(*input, render, context);
  if (!subject) return subject.error();
  auto picture = draw_picture(subject->drawn.model, subject->drawn.drawing, render, context);
  if (!picture) return picture.error();
  if (Status status = save({{render.output, std::move(*picture)}}, subject->files, interruption);
      !status)
    return status;
  print_result(render.output, render.common.quiet);
  return Done{};
}

}  // namespace relievo::cli

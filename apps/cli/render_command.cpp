#include "apps/cli/render_command.h"

#include <memory>

#include "api/inputs.h"
#include "apps/cli/common_arguments.h"
#include "apps/cli/cost.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/pictures.h"
#include "apps/cli/pixel_art.h"
#include "apps/cli/reconstruct.h"
#include "apps/cli/relief_arguments.h"
#include "io/files/paths.h"
#include "io/mesh/glb_decode.h"

namespace relievo::cli {
namespace {

constexpr const char* render_help = R"(Renders a picture of a model, or of the relief of a drawing.

Examples:
  relievo render wolf.glb -o wolf.png
  relievo render wolf.svg -o wolf.png --view side --clay
  relievo render wolf.glb -o eye.png --view front --window 500 200 150)";

/// A model to render.
struct Subject {
  relief::DrawnModel drawn;
  std::vector<std::filesystem::path> files;  ///< inputs, never overwritten
};

Result<Subject> load_model(const InputFile& input, const RenderArguments& render) {
  auto drawn = decode_glb(input.bytes);
  if (!drawn) return in_file(drawn.error(), input.name);
  settle_pixel_art(render.common, drawn->drawing);
  Subject subject{std::move(*drawn), {}};
  if (input.name != "-") subject.files.emplace_back(input.name);
  return subject;
}

Result<Subject> build_model(const InputFile& input, const RenderArguments& render,
                            const RunContext& context) {
  if (Status s = check_cost(render.relief.options); !s) return s.error();
  auto loaded = load_scene(input, render.common.connect, context);
  if (!loaded) return loaded.error();
  settle_pixel_art(render.common, loaded->drawing);
  const auto relief = reconstruct(*loaded, render.relief, context);
  print_warnings(loaded->warnings);
  if (!relief) return relief.error();
  // Clay shows no ink.
  if (render.clay && !render.relief.solid.value_or(false)) loaded->drawing = {};
  auto drawn =
      make_model(*relief, *loaded, render.relief, render.relief.ink.value_or(Ink::shell), context);
  if (!drawn) return drawn.error();
  return Subject{std::move(drawn->drawn), std::move(loaded->files)};
}

Status run_render(const RenderArguments& render, Interruption& interruption) {
  if (Status status = check_outputs({render.output}, {render.common.input}); !status) return status;
  const auto input = read_input(render.common.input);
  if (!input) return input.error();
  Progress progress;
  const RunContext context = progress.context(interruption.flag());
  const auto subject = sniff(input->bytes) == InputKind::glb ? load_model(*input, render)
                                                             : build_model(*input, render, context);
  if (!subject) return subject.error();
  Outputs outputs;
  outputs.add(render.output, [&] {
    return draw_picture(subject->drawn.model, subject->drawn.drawing, render, context);
  });
  if (Status s = save(outputs, subject->files, interruption); !s) return s;
  print_result(render.output);
  return Done{};
}

}  // namespace

void add_render(CLI::App& main, Command& chosen) {
  const auto render = std::make_shared<RenderArguments>();
  CLI::App& app = *main.add_subcommand("render", render_help);
  add_common(app, render->common, "Model (.glb), or any input of build; - reads standard input");
  add_connect(app, render->common);
  add_pixel_art(app, render->common);
  add_path(app, "-o,--output", render->output, "Picture (.png)")->required();
  add_choice(app, "--view", render->view, "front, three-quarter (the default), side or sheet",
             {{"front", View::front},
              {"three-quarter", View::three_quarter},
              {"side", View::side},
              {"sheet", std::nullopt}});
  app.add_option("--yaw", render->yaw,
                 "Turns the camera to the right, in degrees; overrides --view")
      ->check(within(-360.0, 360.0));
  app.add_option("--pitch", render->pitch, "Raises the camera, in degrees; overrides --view")
      ->check(within(-90.0, 90.0));
  app.add_option("--light", render->light,
                 "Direction of the light: degrees to the right, and above")
      ->expected(2)
      ->check(within(-360.0, 360.0));
  app.add_option("--size", render->size, "Longest side of a view in px (default 1200)")
      ->check(CLI::Range(16, 8192));
  app.add_flag("--clay", render->clay, "Leaves out the colours of the drawing");
  app.add_option("--window", render->window,
                 "Shows a detail: x and y of its centre and its width, in canvas px")
      ->expected(3);
  add_relief_options(app, render->relief);
  add_visibility(app, render->relief);
  app.callback([render, &chosen] { chosen = command(render, run_render); });
}

}  // namespace relievo::cli

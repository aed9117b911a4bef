#include "apps/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <type_traits>

#include "apps/cli/batch/batch_arguments.h"
#include "apps/cli/batch/batch_command.h"
#include "apps/cli/build_arguments.h"
#include "apps/cli/build_command.h"
#include "apps/cli/check_command.h"
#include "apps/cli/common_arguments.h"
#include "apps/cli/exit_code.h"
#include "apps/cli/manual/completions.h"
#include "apps/cli/manual/help_text.h"
#include "apps/cli/manual/man_page.h"
#include "apps/cli/relief_arguments.h"
#include "apps/cli/render_command.h"
#include "apps/cli/segment_command.h"
#include "apps/cli/sequence/sequence_arguments.h"
#include "apps/cli/sequence/sequence_command.h"
#include "apps/cli/solid_arguments.h"
#include "apps/cli/version.h"
#include "apps/cli/within.h"

namespace relievo::cli {
namespace {

constexpr const char* main_help =
    R"(Turns a drawing of a character, layered or flat, into a seamless high relief.

Examples:
  relievo build wolf.svg -o wolf.glb
  relievo build wolf.svg -o wolf.glb --preview wolf.png --normal-map wolf-normal.png
  relievo build photo.jpg -o photo.glb --overlay understood.png
  relievo check wolf.svg
  relievo render wolf.glb -o wolf-sheet.png --view sheet)";

constexpr const char* check_help =
    R"(Reads a drawing, lists its parts and joins, and reports mistakes. Writes only the files that you
name: the scene, to be edited and built, and a picture of how the drawing was understood.

Examples:
  relievo check wolf.svg
  relievo check wolf.svg --overlay understood.png
  relievo check wolf.svg -o wolf.json
  relievo check wolf.svg --profile figure --size 60)";

constexpr const char* render_help = R"(Renders a picture of a model, or of the relief of a drawing.

Examples:
  relievo render wolf.glb -o wolf.png
  relievo render wolf.svg -o wolf.png --view side --clay
  relievo render wolf.glb -o eye.png --view front --window 500 200 150)";

constexpr const char* segment_help =
    R"(Turns a flat drawing into a scene. Finds the parts, completes the regions that other parts hide,
orders the parts in depth and proposes joins. An SVG drawing is first painted as a picture.

Examples:
  relievo segment wolf.png -o wolf.relievo
  relievo segment photo.jpg --scribbles strokes.png -o wolf.relievo --overlay understood.png
  relievo segment wolf.png --labels wolf-parts.png -o wolf.json --overlay understood.png
  relievo segment wolf.png -o wolf.psd
  relievo build wolf.relievo -o wolf.glb)";

void add_check(CLI::App& main, CheckArguments& check) {
  CLI::App& app = *main.add_subcommand("check", check_help);
  add_common(app, check.common, input_help);
  add_connect(app, check.common);
  app.add_option("-o,--output", check.output, "The scene, with everything that was guessed (.json)")
      ->check(extension({".json"}));
  app.add_option(
         "--overlay", check.overlay,
         "Picture of the drawing with its parts, joins, relations and soft ranges marked (.png)")
      ->check(extension({".png"}));
  add_solid_options(app, check.relief);
  app.add_option("--size", check.relief.solid_options.size,
                 "Longest side of a solid or figure in mm (default 100)")
      ->check(within(1.0, 10000.0));
}

void add_segment(CLI::App& main, SegmentArguments& segment) {
  CLI::App& app = *main.add_subcommand("segment", segment_help);
  add_common(app, segment.common,
             "Drawing (.png, .jpg, .gif, .svg), or a project, whose corrections are applied");
  auto* labels =
      app.add_option(
             "--labels", segment.labels,
             "Grey or palette picture whose values number the parts; 0 is background (.png)")
          ->check(extension({".png"}));
  app.add_option(
         "--scribbles", segment.scribbles,
         "Strokes that mark the parts: a picture with one colour for each part (.png), or a "
         "scribble file (.json)")
      ->check(extension({".png", ".json"}))
      ->excludes(labels);
  app.add_option("--figure", segment.figure,
                 "Mask of the figure, white or opaque (.png): all of it becomes parts, and nothing "
                 "else does")
      ->check(extension({".png"}))
      ->excludes(labels);
  app.add_option(
         "--parts", segment.parts,
         "Approximate number of parts: the pieces that most likely belong together are merged, or "
         "the least certain parts divided (default: decided by lines and colours)")
      ->check(CLI::Range(1, 1000))
      ->excludes(labels);
  app.add_option("-o,--output", segment.output,
                 "Project (.relievo), scene file (.json), or the parts as layers "
                 "for further painting (.psd)")
      ->required()
      ->check(extension({".relievo", ".json", ".psd"}));
  app.add_option("--overlay", segment.overlay,
                 "Picture of the drawing with its parts and joins marked (.png)")
      ->check(extension({".png"}));
  app.add_option("--report", segment.report, "The parts and guesses, with their confidence (.json)")
      ->check(extension({".json"}));
}

void add_render(CLI::App& main, RenderArguments& render) {
  CLI::App& app = *main.add_subcommand("render", render_help);
  add_common(app, render.common, "Model (.glb), or any input of build; - reads standard input");
  add_connect(app, render.common);
  app.add_option("-o,--output", render.output, "Picture (.png)")
      ->required()
      ->check(extension({".png"}));
  app.add_option("--view", render.view, "front, three-quarter (the default), side or sheet")
      ->check(CLI::IsMember({"front", "three-quarter", "side", "sheet"}));
  app.add_option("--yaw", render.yaw, "Turns the camera to the right, in degrees; overrides --view")
      ->check(within(-360.0, 360.0));
  app.add_option("--pitch", render.pitch, "Raises the camera, in degrees; overrides --view")
      ->check(within(-90.0, 90.0));
  app.add_option("--light", render.light, "Direction of the light: degrees to the right, and above")
      ->expected(2)
      ->check(within(-360.0, 360.0));
  app.add_option("--size", render.size, "Longest side of a view in px (default 1200)")
      ->check(CLI::Range(16, 8192));
  app.add_flag("--clay", render.clay, "Leaves out the colours of the drawing");
  app.add_option("--window", render.window,
                 "Shows a detail: x and y of its centre and its width, in canvas px")
      ->expected(3);
  add_relief_options(app, render.relief);
  add_visibility(app, render.relief);
}

struct ManualArguments {
  std::string what;
  std::string command;
};

/// Adds the command that packages use to print manual pages. Help does not show it.
void add_manual(CLI::App& main, ManualArguments& manual) {
  CLI::App& app = *main.add_subcommand("manual", "Prints a manual page or a shell's completions.");
  app.group("");
  app.add_option("WHAT", manual.what, "man, bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"man", "bash", "zsh", "fish"}));
  std::vector<std::string> names;
  for (const CLI::App* command : shown_commands(main)) names.push_back(command->get_name());
  app.add_option("COMMAND", manual.command,
                 "The command whose page is printed (default: that of the program)")
      ->check(CLI::IsMember(names));
}

int print_manual(const CLI::App& app, const ManualArguments& manual) {
  std::cout << (manual.what == "man" ? man_page(app, manual.command)
                                     : completions(app, manual.what));
  return exit_done;
}

/// Prints help and the version on standard output, errors on standard error.
int finish(const CLI::App& app, const CLI::ParseError& error) {
  return app.exit(error, std::cout, std::cerr) == 0 ? exit_done : exit_usage;
}

/// The command that runs `run` with the arguments. `run` returns a Status, or an exit code.
template <class Arguments, class Run>
Command command(const Arguments& arguments, Run run) {
  return {arguments.common, [arguments, run](Interruption& interruption) -> Result<int> {
            const auto done = run(arguments, interruption);
            if (!done) return done.error();
            if constexpr (std::is_same_v<std::decay_t<decltype(*done)>, int>) return *done;
            return exit_done;
          }};
}

}  // namespace

ParsedArguments parse_arguments(int argc, const char* const* argv) {
  // "help" and "help COMMAND" mean --help and COMMAND --help.
  std::vector<const char*> words(argv, argv + argc);
  if (argc > 1 && argc < 4 && std::string(argv[1]) == "help") {
    words.erase(words.begin() + 1);
    words.push_back("--help");
  }
  CLI::App app(main_help, "relievo");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(0, 1);
  BuildArguments build;
  CheckArguments check;
  RenderArguments render;
  SegmentArguments segment;
  SequenceArguments sequence;
  BuildArguments choices;
  BatchArguments batch;
  add_build(app, build);
  const CLI::App& batch_app = add_batch(app, batch, choices);
  add_check(app, check);
  add_render(app, render);
  add_segment(app, segment);
  add_sequence(app, sequence);
  ManualArguments manual;
  add_manual(app, manual);
  try {
    app.parse(static_cast<int>(words.size()), words.data());
    if (app.got_subcommand("manual")) return print_manual(app, manual);
    if (app.got_subcommand("check")) return command(check, run_check);
    if (app.got_subcommand("render")) return command(render, run_render);
    if (app.got_subcommand("segment")) return command(segment, run_segment);
    if (app.got_subcommand("batch")) {
      settle_batch(batch_app, batch);
      return command(batch, run_batch);
    }
    if (app.got_subcommand("sequence")) return command(sequence, run_sequence);
    if (!app.got_subcommand("build"))
      throw CLI::RequiredError("A command (build, batch, check, render, segment or sequence)");
    settle_build(build);
    return command(build, run_build);
  } catch (const CLI::ParseError& error) {
    return finish(app, error);
  }
}

}  // namespace relievo::cli

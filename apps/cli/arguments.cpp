#include "apps/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "apps/cli/batch/batch_arguments.h"
#include "apps/cli/build_arguments.h"
#include "apps/cli/common_arguments.h"
#include "apps/cli/compare_arguments.h"
#include "apps/cli/exit_code.h"
#include "apps/cli/manual/completions.h"
#include "apps/cli/manual/help_text.h"
#include "apps/cli/manual/man_page.h"
#include "apps/cli/relief_arguments.h"
#include "apps/cli/sequence/sequence_arguments.h"
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
    R"(Reads a drawing, tells what its parts and joins are and what is wrong. Writes nothing but what
is asked for: the scene as it was understood, to be edited and built, and a picture of it.

Examples:
  relievo check wolf.svg
  relievo check wolf.svg --overlay understood.png
  relievo check wolf.svg -o wolf.json
  relievo check wolf.svg --profile figure --size 60)";

constexpr const char* render_help = R"(Makes a picture of a model, or of a drawing's relief.

Examples:
  relievo render wolf.glb -o wolf.png
  relievo render wolf.svg -o wolf.png --view side --clay
  relievo render wolf.glb -o eye.png --view front --window 500 200 150)";

constexpr const char* segment_help =
    R"(Makes a scene of a flat drawing: finds its parts, completes what they hide of each other, orders
them in depth, proposes joins. An SVG drawing is taken as the picture that it paints.

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
  app.add_option("-o,--output", check.output, "The scene as it was understood (.json)")
      ->check(extension({".json"}));
  app.add_option("--overlay", check.overlay,
                 "Parts, joins, relations and soft ranges, over the drawing (.png)")
      ->check(extension({".png"}));
  add_solid_options(app, check.relief);
  app.add_option("--size", check.relief.solid_options.size,
                 "Of solid and figure: longest side in mm (default 100)")
      ->check(within(1.0, 10000.0));
}

void add_segment(CLI::App& main, SegmentArguments& segment) {
  CLI::App& app = *main.add_subcommand("segment", segment_help);
  add_common(app, segment.common,
             "Drawing (.png, .jpg, .gif, .svg), or a project whose corrections are to be applied");
  auto* labels =
      app.add_option("--labels", segment.labels,
                     "Picture whose values are parts, 0 is background: grey or palette (.png)")
          ->check(extension({".png"}));
  app.add_option("--scribbles", segment.scribbles,
                 "Strokes that say which part is where: a picture, one colour a part (.png), or a "
                 "scribble file (.json)")
      ->check(extension({".png", ".json"}))
      ->excludes(labels);
  app.add_option("--figure", segment.figure,
                 "Picture that is white, or opaque, where the figure is (.png): all of it becomes "
                 "parts, and nothing else")
      ->check(extension({".png"}))
      ->excludes(labels);
  app.add_option(
         "--parts", segment.parts,
         "Find about so many parts: the likeliest to be one are united, or the least likely "
         "divided (default: as many as lines and colours tell)")
      ->check(CLI::Range(1, 1000))
      ->excludes(labels);
  app.add_option("-o,--output", segment.output,
                 "Project (.relievo), scene file (.json), or the parts as layers "
                 "to go on painting (.psd)")
      ->required()
      ->check(extension({".relievo", ".json", ".psd"}));
  app.add_option("--overlay", segment.overlay, "What was understood, over the drawing (.png)")
      ->check(extension({".png"}));
  app.add_option("--report", segment.report, "Parts, guesses and how sure they are (.json)")
      ->check(extension({".json"}));
}

void add_render(CLI::App& main, RenderArguments& render) {
  CLI::App& app = *main.add_subcommand("render", render_help);
  add_common(app, render.common, "Model (.glb), or what build takes; - reads standard input");
  add_connect(app, render.common);
  app.add_option("-o,--output", render.output, "Picture (.png)")
      ->required()
      ->check(extension({".png"}));
  app.add_option("--view", render.view, "front, three-quarter (the default), side or sheet")
      ->check(CLI::IsMember({"front", "three-quarter", "side", "sheet"}));
  app.add_option("--yaw", render.yaw, "Turn to the right in degrees, in place of the view's")
      ->check(within(-360.0, 360.0));
  app.add_option("--pitch", render.pitch, "Look from above in degrees, in place of the view's")
      ->check(within(-90.0, 90.0));
  app.add_option("--light", render.light, "Light from so many degrees to the right, and above")
      ->expected(2)
      ->check(within(-360.0, 360.0));
  app.add_option("--size", render.size, "Longest side of a view in px (default 1200)")
      ->check(CLI::Range(16, 8192));
  app.add_flag("--clay", render.clay, "Without the colours of the drawing");
  app.add_option("--window", render.window, "Look closely: middle x, y and width in canvas px")
      ->expected(3);
  add_relief_options(app, render.relief);
  add_visibility(app, render.relief);
}

struct ManualArguments {
  std::string what;
  std::string command;
};

/// For packages, which is why help does not show it.
void add_manual(CLI::App& main, ManualArguments& manual) {
  CLI::App& app = *main.add_subcommand("manual", "Prints a manual page or a shell's completions.");
  app.group("");
  app.add_option("WHAT", manual.what, "man, bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"man", "bash", "zsh", "fish"}));
  std::vector<std::string> names;
  for (const CLI::App* command : shown_commands(main)) names.push_back(command->get_name());
  app.add_option("COMMAND", manual.command, "Whose page it is; the program's where none is named")
      ->check(CLI::IsMember(names));
}

int print_manual(const CLI::App& app, const ManualArguments& manual) {
  std::cout << (manual.what == "man" ? man_page(app, manual.command)
                                     : completions(app, manual.what));
  return exit_done;
}

/// Prints help and the version on standard output, mistakes on standard error.
int finish(const CLI::App& app, const CLI::ParseError& error) {
  return app.exit(error, std::cout, std::cerr) == 0 ? exit_done : exit_usage;
}

}  // namespace

ParsedArguments parse_arguments(int argc, const char* const* argv) {
  // "help" and "help COMMAND" are what others type for --help and COMMAND --help.
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
  CompareArguments compare;
  RenderArguments render;
  SegmentArguments segment;
  SequenceArguments sequence;
  BuildArguments choices;
  BatchArguments batch;
  add_build(app, build);
  const CLI::App& batch_app = add_batch(app, batch, choices);
  add_check(app, check);
  add_compare(app, compare);
  add_render(app, render);
  add_segment(app, segment);
  add_sequence(app, sequence);
  ManualArguments manual;
  add_manual(app, manual);
  try {
    app.parse(static_cast<int>(words.size()), words.data());
    if (app.got_subcommand("manual")) return print_manual(app, manual);
    if (app.got_subcommand("check")) return Command(check);
    if (app.got_subcommand("compare")) {
      settle_compare(compare);
      return Command(compare);
    }
    if (app.got_subcommand("render")) return Command(render);
    if (app.got_subcommand("segment")) return Command(segment);
    if (app.got_subcommand("batch")) {
      settle_batch(batch_app, batch);
      return Command(batch);
    }
    if (app.got_subcommand("sequence")) return Command(sequence);
    if (!app.got_subcommand("build"))
      throw CLI::RequiredError(
          "A command (build, batch, check, compare, render, segment or sequence)");
    settle_build(build);
    return Command(build);
  } catch (const CLI::ParseError& error) {
    return finish(app, error);
  }
}

}  // namespace relievo::cli

#include "apps/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "apps/cli/exit_code.h"
#include "apps/cli/relief_arguments.h"
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

constexpr const char* build_help = R"(Reconstructs a drawing and writes models, maps and pictures.

Examples:
  relievo build wolf.svg -o wolf.glb
  relievo build photo.jpg -o photo.glb --overlay understood.png
  relievo build wolf.svg -o wolf.stl --size 80 --vertices 100000
  relievo build scene.json --depth-map depth.png --json
  cat wolf.svg | relievo build - -o wolf.glb)";

constexpr const char* check_help =
    R"(Reads a drawing, tells what its parts and joins are and what is wrong. Writes nothing but what
is asked for: the scene as it was understood, to be edited and built, and a picture of it.

Examples:
  relievo check wolf.svg
  relievo check wolf.svg --overlay understood.png
  relievo check wolf.svg -o wolf.json)";

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
  relievo build wolf.relievo -o wolf.glb)";

constexpr const char* input_help =
    "Layered drawing (SVG, OpenRaster, a folder of pictures), flat picture (PNG, JPEG, GIF), "
    "project or scene file (JSON); - reads standard input";

void add_common(CLI::App& app, CommonArguments& common, const char* what) {
  app.add_option("INPUT", common.input, what)->required();
  app.add_flag("-q,--quiet", common.quiet, "Say nothing but errors");
  app.add_option("--timeout", common.timeout, "Give up after so many seconds")
      ->check(CLI::PositiveNumber);
  app.add_option("--threads", common.threads,
                 "Threads to use (default: as many as there are); the results are the same")
      ->check(CLI::Range(1, 256));
}

void add_connect(CLI::App& app, CommonArguments& common) {
  app.add_option_function<std::string>(
         "--connect", [&common](const std::string& how) { common.connect = how == "auto"; },
         "Joins of layered drawings that say none: auto guesses them (the default), none stacks "
         "the parts")
      ->check(CLI::IsMember({"auto", "none"}));
}

/// A usage error where the file's extension is none of those given.
CLI::Validator extension(const std::vector<std::string>& allowed) {
  const auto check = [=](const std::string& name) -> std::string {
    std::string known;
    for (const std::string& end : allowed) {
      const bool fits = name.size() > end.size() && name.substr(name.size() - end.size()) == end;
      if (fits) return "";
      known += (known.empty() ? "" : ", ") + end;
    }
    return "\"" + name + "\" must end in " + known;
  };
  return {check, "", "extension"};
}

void add_build(CLI::App& main, BuildArguments& build) {
  CLI::App& app = *main.add_subcommand("build", build_help);
  add_common(app, build.common, input_help);
  add_connect(app, build.common);
  app.add_option("-o,--output", build.models,
                 "Model: .glb, .obj, .ply, .stl or .3mf; may be repeated")
      ->check(extension({".glb", ".obj", ".ply", ".stl", ".3mf"}))
      ->expected(1)
      ->take_all();
  app.add_option("--size", build.size_mm, "Longest side in mm (default 100)")
      ->check(within(0.001, 1e6));
  app.add_option("--filaments", build.filaments,
                 "Paint a .3mf with so many colours at most (default 4)")
      ->check(CLI::Range(1, 16));
  app.add_option_function<std::string>(
         "--slicer",
         [&build](const std::string& name) {
           build.slicer = name == "bambu" ? Slicer::bambu : Slicer::prusa;
         },
         "Paint a .3mf for prusa (the default) or bambu, whose paint the other does not read")
      ->check(CLI::IsMember({"prusa", "bambu"}));
  const auto picture = extension({".png"});
  app.add_option("--normal-map", build.normal_map, "Normals (.png)")->check(picture);
  app.add_option_function<std::string>(
         "--normal-y", [&build](const std::string& sign) { build.normal_y_down = sign == "-"; },
         "Green of the normal map: + is up (OpenGL), - is down (DirectX)")
      ->check(CLI::IsMember({"+", "-"}));
  app.add_option("--depth-map", build.depth_map, "Heights, 16 bit, near is white (.png)")
      ->check(picture);
  app.add_option("--part-map", build.part_map, "Numbers of the parts, 16 bit (.png)")
      ->check(picture);
  app.add_option("--map-size", build.map_size, "Longest side of the maps in px (default 2048)")
      ->check(CLI::Range(1, 16384));
  app.add_option("--preview", build.preview, "Picture of the model (.png)")->check(picture);
  app.add_option("--preview-size", build.preview_size, "Its longest side in px (default 1200)")
      ->check(CLI::Range(16, 8192));
  app.add_option("--overlay", build.overlay, "What was understood, over the drawing (.png)")
      ->check(picture);
  app.add_option("--convergence", build.convergence,
                 "Of nonlinear: the surface after some of its steps, side by side (.png)")
      ->check(picture);
  app.add_option("--report", build.report, "What was computed, how exactly, how fast (.json)")
      ->check(extension({".json"}));
  app.add_flag("--json", build.print_report, "Print the report on standard output");
  add_relief_options(app, build.relief);
  add_visibility(app, build.relief);
}

void add_check(CLI::App& main, CheckArguments& check) {
  CLI::App& app = *main.add_subcommand("check", check_help);
  add_common(app, check.common, input_help);
  add_connect(app, check.common);
  app.add_option("-o,--output", check.output, "The scene as it was understood (.json)")
      ->check(extension({".json"}));
  app.add_option("--overlay", check.overlay,
                 "Parts, joins, relations and soft ranges, over the drawing (.png)")
      ->check(extension({".png"}));
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
  app.add_option("-o,--output", segment.output, "Project (.relievo) or scene file (.json)")
      ->required()
      ->check(extension({".relievo", ".json"}));
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

bool wants_nothing(const BuildArguments& build) {
  return build.models.empty() && build.normal_map.empty() && build.depth_map.empty() &&
         build.part_map.empty() && build.preview.empty() && build.overlay.empty() &&
         build.convergence.empty() && build.report.empty() && !build.print_report;
}

bool wants_3mf(const BuildArguments& build) {
  return std::any_of(build.models.begin(), build.models.end(),
                     [](const std::string& name) { return name.ends_with(".3mf"); });
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
  app.set_version_flag("--version", "relievo " RELIEVO_VERSION);
  app.require_subcommand(0, 1);
  BuildArguments build;
  CheckArguments check;
  RenderArguments render;
  SegmentArguments segment;
  add_build(app, build);
  add_check(app, check);
  add_render(app, render);
  add_segment(app, segment);
  try {
    app.parse(static_cast<int>(words.size()), words.data());
    if (app.got_subcommand("check")) return Command(check);
    if (app.got_subcommand("render")) return Command(render);
    if (app.got_subcommand("segment")) return Command(segment);
    if (!app.got_subcommand("build"))
      throw CLI::RequiredError("A command (build, check, render or segment)");
    if (wants_nothing(build))
      throw CLI::ValidationError("nothing to write: give -o, a map, --preview, --report or --json");
    if (!build.convergence.empty() && build.relief.options.method != Method::nonlinear)
      throw CLI::ValidationError("--convergence needs --method nonlinear: the other has no steps");
    if (wants_3mf(build) && !build.relief.solid)
      throw CLI::ValidationError("a .3mf holds solids alone: add --profile solid");
    return Command(build);
  } catch (const CLI::ParseError& error) {
    return finish(app, error);
  }
}

}  // namespace relievo::cli

#include "apps/cli/sequence/sequence_arguments.h"

#include <cstdio>

#include "apps/cli/common_arguments.h"
#include "apps/cli/relief_arguments.h"

namespace relievo::cli {
namespace {

constexpr const char* help =
    R"(Makes consistent maps for the frames of an animation. All frames have the same scale and depth
range, parts of the same name have the same number, and still parts keep their heights. The
frames are drawings of the same size, in order, or the sprites of a sheet.

Examples:
  relievo sequence walk-*.svg -o maps
  relievo sequence walk-*.svg -o maps --columns 5 --make colour,normal,depth,part,occlusion
  relievo sequence walk.json -o maps
  relievo sequence walk.png --grid 8x2 -o maps)";

ImageSize grid(const std::string& text) {
  ImageSize cells;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%dx%d%c", &cells.width, &cells.height, &rest);
  const auto sound = [](int n) { return n >= 1 && n <= 1000; };
  if (read != 2 || !sound(cells.width) || !sound(cells.height))
    throw CLI::ValidationError("--grid " + text, "must be columns and rows, of the form 8x2");
  return cells;
}

}  // namespace

void add_sequence(CLI::App& main, SequenceArguments& sequence) {
  CLI::App& app = *main.add_subcommand("sequence", help);
  app.add_option("INPUT", sequence.inputs,
                 "Drawings as for build, or a sprite sheet: its list of sprites, as written by "
                 "Aseprite or TexturePacker (.json), or its picture with --grid")
      ->required();
  app.add_option("-o,--output", sequence.output, "Output folder")->required();
  app.add_option("--make", sequence.make,
                 "Outputs for each frame, separated by commas: colour, normal, depth, part, "
                 "occlusion (default: colour,normal,depth)")
      ->delimiter(',')
      ->check(CLI::IsMember({"colour", "normal", "depth", "part", "occlusion"}));
  auto* cells = app.add_option_function<std::string>(
      "--grid", [&sequence](const std::string& text) { sequence.grid = grid(text); },
      "Columns and rows of a sprite sheet, such as 8x2");
  app.add_option(
         "--columns", sequence.columns,
         "Writes the frames on one sheet with this many columns, and a list of them (.json)")
      ->check(CLI::Range(1, 1000))
      ->excludes(cells);
  app.add_option(
         "--map-size", sequence.map_size,
         "Longest side of the maps of drawings in px (default 1024); sprites keep their size")
      ->check(CLI::Range(1, 8192));
  app.add_option_function<std::string>(
         "--normal-y",
         [&sequence](const std::string& sign) { sequence.normal_y_down = sign == "-"; },
         "Green of the normal map: + is up (OpenGL), - is down (DirectX)")
      ->check(CLI::IsMember({"+", "-"}));
  add_run_options(app, sequence.common);
  add_connect(app, sequence.common);
  add_relief_options(app, sequence.relief);
}

}  // namespace relievo::cli

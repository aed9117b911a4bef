#include "apps/cli/sequence/sequence_arguments.h"

#include <cstdio>

#include "apps/cli/common_arguments.h"
#include "apps/cli/relief_arguments.h"

namespace relievo::cli {
namespace {

constexpr const char* help =
    R"(Makes maps of the frames of an animation that go together: one scale, one range of depth, parts
of one name have one number, and what stands still keeps its height. The frames are drawings
of one size in their order, or the sprites of a sheet, whose maps have its layout.

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
    throw CLI::ValidationError("--grid " + text, "is not columns and rows, of the form 8x2");
  return cells;
}

}  // namespace

void add_sequence(CLI::App& main, SequenceArguments& sequence) {
  CLI::App& app = *main.add_subcommand("sequence", help);
  app.add_option("INPUT", sequence.inputs,
                 "Drawings as build takes them, or a sheet: the list of its sprites as Aseprite "
                 "and TexturePacker write it (.json), or its picture with --grid")
      ->required();
  app.add_option("-o,--output", sequence.output, "Folder of the results")->required();
  app.add_option("--make", sequence.make,
                 "What to make of each frame, between commas: colour, normal, depth (these are the "
                 "default), part, occlusion")
      ->delimiter(',')
      ->check(CLI::IsMember({"colour", "normal", "depth", "part", "occlusion"}));
  auto* cells = app.add_option_function<std::string>(
      "--grid", [&sequence](const std::string& text) { sequence.grid = grid(text); },
      "The picture is a sheet of so many columns and rows; 8x2");
  app.add_option("--columns", sequence.columns,
                 "Put the frames on one sheet with so many columns, and list them (.json)")
      ->check(CLI::Range(1, 1000))
      ->excludes(cells);
  app.add_option("--map-size", sequence.map_size,
                 "Longest side of a drawing's maps in px (default 1024); of sprites it is theirs")
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

#include "apps/cli/build_arguments.h"

#include <algorithm>
#include <memory>

#include "apps/cli/build_command.h"
#include "apps/cli/common_arguments.h"
#include "apps/cli/outputs.h"
#include "apps/cli/relief_arguments.h"

namespace relievo::cli {
namespace {

constexpr const char* help = R"(Reconstructs a drawing and writes models, maps and pictures.

Examples:
  relievo build wolf.svg -o wolf.glb
  relievo build photo.jpg -o photo.glb --overlay understood.png
  relievo build wolf.svg -o wolf.stl --size 80
  relievo build scene.json --depth-map depth.png --json
  cat wolf.svg | relievo build - -o wolf.glb)";

void add_print_options(CLI::App& app, BuildArguments& build) {
  add_size(app, build.size_mm, 0.001, 1e6);
  app.add_option("--filaments", build.filaments,
                 "Maximum number of colours that a .3mf is painted with (default 4)")
      ->check(CLI::Range(1, 16));
  add_choice(
      app, "--slicer", build.slicer,
      "Slicer that a .3mf is painted for: prusa (the default) or bambu; each reads only its own",
      {{"prusa", Slicer::prusa}, {"bambu", Slicer::bambu}});
}

void add_level_options(CLI::App& app, BuildArguments& build) {
  app.add_option("--triangles", build.triangles,
                 "Maximum number of triangles in a model, as far as its seams and outlines allow")
      ->check(CLI::Range(4, 100000000));
  app.add_option(
         "--lods", build.levels,
         "Levels of detail: writes this many files of each model, wolf.glb, wolf-lod1.glb, ..., "
         "each with half of the triangles and of the texture's sides")
      ->check(CLI::Range(1, 8));
  app.add_flag("--one-mesh", build.one_mesh,
               "Writes all parts as one mesh: one draw call, but no names of parts");
  app.add_flag("--grounded", build.grounded,
               "Puts the lowest point of a .glb, .obj or .ply at height 0, not its middle");
  app.add_option("--texture-size", build.texture_size,
                 "Maximum longest side of the texture in px (default: that of the drawing); it "
                 "halves with every level of detail")
      ->check(CLI::Range(least_texture_size, max_texture_size));
}

void add_picture_options(CLI::App& app, BuildArguments& build) {
  add_normal_y(app, build.normal_y_down);
  app.add_option(
         "--map-size", build.map_size,
         "Longest side of the maps in px (default 2048; of pixel art the largest multiple of "
         "its size up to that)")
      ->check(CLI::Range(1, 16384));
  app.add_option("--px-per-mm", build.px_per_mm, "Resolution of the carve map (default 10)")
      ->check(within(0.1, 1000.0));
  app.add_option("--preview-size", build.preview_size,
                 "Longest side of the preview in px (default 1200)")
      ->check(CLI::Range(16, 8192));
}

void add_outputs(CLI::App& app, BuildArguments& build) {
  app.add_option("-o,--output", build.models,
                 "Model: .glb, .obj, .ply, .stl, .3mf, .usdz or .html (repeatable)")
      ->check(extension({".glb", ".obj", ".ply", ".stl", ".3mf", ".usdz", ".html"}))
      ->expected(1)
      ->take_all();
  add_path(app, "--normal-map", build.normal_map, "Normal map (.png)");
  add_path(app, "--depth-map", build.depth_map, "Depth map, 16 bit, near is white (.png)");
  add_path(app, "--part-map", build.part_map, "Map of the part numbers, 16 bit (.png)");
  add_path(app, "--carve-map", build.carve_map,
           "Heights of a solid above the bed, 16 bit, for milling (.png)");
  add_path(app, "--occlusion-map", build.occlusion_map,
           "Ambient occlusion: share of an even sky seen by each pixel, white is all of it (.png)");
  add_path(app, "--preview", build.preview, "Picture of the model (.png)");
  add_path(app, "--overlay", build.overlay, overlay_help);
  add_path(app, "--convergence", build.convergence,
           "For nonlinear: the surface after some of the steps, side by side (.png)");
  add_path(app, "--report", build.report,
           "Report with sizes, accuracy, timings and warnings (.json)", {".json"});
  app.add_flag("--json", build.print_report, "Print the report on standard output");
}

bool wants(const BuildArguments& build, const std::vector<std::string>& endings) {
  return std::any_of(build.models.begin(), build.models.end(), [&](const std::string& name) {
    return std::any_of(endings.begin(), endings.end(),
                       [&name](const std::string& ending) { return name.ends_with(ending); });
  });
}

/// Throws CLI::ValidationError if options contradict each other.
void settle_build(const BuildArguments& build) {
  if (planned_outputs(build).empty() && !build.print_report)
    throw CLI::ValidationError("nothing to write: give -o, a map, --preview, --report or --json");
  if (!build.convergence.empty() && build.relief.options.method != Method::nonlinear)
    throw CLI::ValidationError(
        "--convergence needs --method nonlinear, since the approximate method has no steps");
  const auto holds = [](const std::string& name) { return holds_shells(name); };
  if (build.relief.ink == Ink::shell &&
      !std::all_of(build.models.begin(), build.models.end(), holds))
    throw CLI::ValidationError("--ink shell needs .glb, .usdz or .html");
  const bool prints = prints_solids(build.relief);
  if (wants(build, {".3mf"}) && !prints)
    throw CLI::ValidationError(
        "a .3mf can hold only solids: leave out --visible and --profile relief");
  const bool simpler = build.triangles > 0 || build.levels > 1;
  if (simpler && prints && wants(build, {".stl", ".3mf"}))
    throw CLI::ValidationError(
        "a solid to print cannot lose triangles, or it would have gaps: use --vertices in place of "
        "--triangles and --lods");
  const bool flat =
      build.relief.solid.value_or(false) && build.relief.solid_options.back == BackSide::flat;
  if (!build.carve_map.empty() && !flat)
    throw CLI::ValidationError(
        "--carve-map needs --profile solid, since a mill carves from one side");
}

CLI::App& add_build(CLI::App& main, BuildArguments& build) {
  CLI::App& app = *main.add_subcommand("build", help);
  add_common(app, build.common, input_help);
  add_outputs(app, build);
  add_build_choices(app, build);
  return app;
}

}  // namespace

void add_build(CLI::App& main, Command& chosen) {
  const auto build = std::make_shared<BuildArguments>();
  add_build(main, *build).callback([build, &chosen] {
    settle_build(*build);
    chosen = command(build, run_build);
  });
}

void add_build_choices(CLI::App& app, BuildArguments& build) {
  add_connect(app, build.common);
  add_pixel_art(app, build.common);
  add_print_options(app, build);
  add_level_options(app, build);
  add_picture_options(app, build);
  add_relief_options(app, build.relief);
  add_visibility(app, build.relief);
}

Result<BuildArguments> parse_build(const std::string& input,
                                   const std::vector<std::string>& words) {
  BuildArguments build;
  CLI::App app("", "relievo");
  add_build(app, build);
  std::vector<std::string> backwards(words.rbegin(), words.rend());
  backwards.push_back(input);
  backwards.emplace_back("build");
  try {
    app.parse(std::move(backwards));
    settle_build(build);
  } catch (const CLI::ParseError& error) {
    return Error{ErrorCode::usage, error.what(), ""};
  }
  return build;
}

}  // namespace relievo::cli

#include "research/compare/compare_arguments.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "apps/cli/common_arguments.h"
#include "apps/cli/exit_code.h"
#include "apps/cli/relief_arguments.h"
#include "research/compare/compare_command.h"

namespace relievo::research {
namespace {

constexpr const char* help =
    R"(Reconstructs a drawing by a published method and measures the result; see docs/figures.md.

Examples:
  relievo-compare wolf.svg --as ink-and-ray -o wolf-seams.glb --report wolf-seams.json
  relievo-compare wolf.svg --as entem --preview wolf-bulges.png)";

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Rival& rival : rivals()) names.emplace_back(rival.name);
  return names;
}

void add_options(CLI::App& app, CompareArguments& compare) {
  using cli::add_path;
  add_common(app, compare.common, cli::input_help);
  add_connect(app, compare.common);
  add_mesh_options(app, compare.relief);
  app.add_option("--as", compare.method, "Method; docs/cite.md lists the publications")
      ->required()
      ->check(CLI::IsMember(method_names()));
  app.add_option("-o,--output", compare.models, "Model: .glb, .obj, .ply or .stl (repeatable)")
      ->check(cli::extension({".glb", ".obj", ".ply", ".stl"}))
      ->expected(1)
      ->take_all();
  add_path(app, "--preview", compare.preview, "Picture of the model (.png)");
  add_path(app, "--normal-map", compare.normal_map, "Normals of the nearest surface (.png)");
  add_path(app, "--depth-map", compare.depth_map,
           "Heights of the nearest surface, 16 bit, near is white (.png)");
  add_path(app, "--report", compare.report, "Measures of the joins and the contour (.json)",
           {".json"});
  app.add_option("--map-size", compare.map_size, "Longest side of the maps in px (default 1024)")
      ->check(CLI::Range(16, 8192));
  app.add_option("--graft", compare.options.graft,
                 "For ink-and-ray: reach of the graft around a join / its length (default 0.25)")
      ->check(cli::within(0.0, 10.0));
  add_path(app, "--graft-mask", compare.graft_mask,
           "For ink-and-ray: the region to graft instead, white in a picture of the canvas (.png)");
  app.add_option("--cell", compare.options.cell,
                 "For entem: size of the triangles / the radius there (default 0.2)")
      ->check(cli::within(0.05, 1.0));
}

void check_outputs_given(const CompareArguments& compare) {
  const bool nothing = compare.models.empty() && compare.preview.empty() &&
                       compare.normal_map.empty() && compare.depth_map.empty() &&
                       compare.report.empty();
  if (nothing)
    throw CLI::ValidationError("nothing to write: give -o, a map, --preview or --report");
}

}  // namespace

cli::ParsedArguments parse_compare(int argc, const char* const* argv) {
  CLI::App app(help, "relievo-compare");
  const auto compare = std::make_shared<CompareArguments>();
  add_options(app, *compare);
  try {
    app.parse(argc, argv);
    check_outputs_given(*compare);
    return cli::command(compare, run_compare);
  } catch (const CLI::ParseError& error) {
    return app.exit(error, std::cout, std::cerr) == 0 ? cli::exit_done
                                                      : cli::exit_code(ErrorCode::usage);
  }
}

}  // namespace relievo::research

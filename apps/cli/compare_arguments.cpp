#include "apps/cli/compare_arguments.h"

#include <string>
#include <vector>

#include "apps/cli/common_arguments.h"
#include "apps/cli/relief_arguments.h"
#include "apps/cli/within.h"

namespace relievo::cli {
namespace {

constexpr const char* compare_help =
    R"(Reconstructs a drawing as another method does, and measures it: see docs/figures.md.

Examples:
  relievo compare wolf.svg --as ink-and-ray -o wolf-seams.glb --report wolf-seams.json
  relievo compare wolf.svg --as entem --preview wolf-bulges.png)";

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Rival& rival : rivals()) names.emplace_back(rival.name);
  return names;
}

}  // namespace

void add_compare(CLI::App& main, CompareArguments& compare) {
  CLI::App& app = *main.add_subcommand("compare", compare_help);
  add_common(app, compare.common, input_help);
  add_connect(app, compare.common);
  add_mesh_options(app, compare.relief);
  app.add_option("--as", compare.method, "Method; docs/cite.md tells where each was published")
      ->required()
      ->check(CLI::IsMember(method_names()));
  app.add_option("-o,--output", compare.models, "Model: .glb, .obj, .ply or .stl; may be repeated")
      ->check(extension({".glb", ".obj", ".ply", ".stl"}))
      ->expected(1)
      ->take_all();
  const CLI::Validator picture = extension({".png"});
  app.add_option("--preview", compare.preview, "Picture (.png)")->check(picture);
  app.add_option("--normal-map", compare.normal_map, "Normals of what is nearest (.png)")
      ->check(picture);
  app.add_option("--depth-map", compare.depth_map, "Heights of it, 16 bit, near is white (.png)")
      ->check(picture);
  app.add_option("--report", compare.report, "What its joins and contour measure (.json)")
      ->check(extension({".json"}));
  app.add_option("--map-size", compare.map_size, "Longest side of the maps in px (default 1024)")
      ->check(CLI::Range(16, 8192));
  app.add_option("--graft", compare.options.graft,
                 "Of ink-and-ray: reach of the graft around a join / its length (default 0.25)")
      ->check(within(0.0, 10.0));
  app.add_option("--graft-mask", compare.graft_mask,
                 "Of ink-and-ray: what is grafted instead, white in a picture of the canvas (.png)")
      ->check(picture);
  app.add_option("--cell", compare.options.cell,
                 "Of entem: size of its triangles / the radius there (default 0.2)")
      ->check(within(0.05, 1.0));
}

void settle_compare(const CompareArguments& compare) {
  const bool nothing = compare.models.empty() && compare.preview.empty() &&
                       compare.normal_map.empty() && compare.depth_map.empty() &&
                       compare.report.empty();
  if (nothing)
    throw CLI::ValidationError("nothing to write: give -o, a map, --preview or --report");
}

}  // namespace relievo::cli

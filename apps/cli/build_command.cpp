#include "apps/cli/build_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/cli/cost.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/overlay_picture.h"
#include "apps/cli/pictures.h"
#include "apps/cli/reconstruct.h"
#include "apps/cli/report.h"
#include "face/inputs.h"
#include "io/image/png_encode.h"
#include "io/maps/carve_map.h"
#include "io/maps/encode_maps.h"
#include "io/mesh/placement.h"
#include "kernel/base/stopwatch.h"
#include "kernel/image/image_size.h"
#include "lod/simplify_model.h"
#include "relief/maps/ambient_occlusion.h"
#include "relief/maps/relief_maps.h"
#include "relievo/export.h"
#include "relievo/maps.h"

namespace relievo::cli {
namespace {

/// What a build has made so far.
struct Products {
  std::vector<OutputFile> files;
  std::optional<MadeModel> made;
  std::optional<Model> written;  ///< in place of the one that was made
  std::vector<std::string> warnings;
};

Status add(Products& products, const std::string& name, Result<Bytes> bytes) {
  if (!bytes) return bytes.error();
  products.files.push_back({name, std::move(*bytes)});
  return Done{};
}

/// Files for printers and files to look at.
struct ModelNames {
  std::vector<std::string> printed;
  std::vector<std::string> shown;
};

/// Sorts the names of models: files for printers hold what the front shows (exported_visibility),
/// unless the arguments ask for a solid or for other faces.
ModelNames sort_models(const BuildArguments& build) {
  ModelNames names;
  for (const std::string& name : build.models) {
    const bool apart = exported_visibility(name) == Visibility::relief &&
                       !build.relief.visibility && !build.relief.solid;
    (apart ? names.printed : names.shown).push_back(name);
  }
  return names;
}

Status add_preview(Products& products, const BuildArguments& build, const RunContext& context) {
  if (build.preview.empty()) return Done{};
  RenderArguments picture;
  picture.size = build.preview_size;
  const relief::DrawnModel& drawn = products.made->drawn;
  return add(products, build.preview, draw_picture(drawn.model, drawn.drawing, picture, context));
}

Status add_carve_map(Products& products, const BuildArguments& build) {
  if (build.carve_map.empty()) return Done{};
  const double base = build.relief.solid_options.thickness;
  return add(products, build.carve_map,
             encode_carve_map(products.made->drawn.model, build.px_per_mm, base));
}

const Model* written_model(const Products& products) {
  if (products.written) return &*products.written;
  return products.made ? &products.made->drawn.model : nullptr;
}

/// What of the made model is written as a level of detail.
void make_level(Products& products, const BuildArguments& build, int level) {
  if (build.triangles == 0 && build.levels == 1 && !build.one_mesh) return;
  const Model& made = products.made->drawn.model;
  Model model = build.one_mesh ? unite_parts(made) : made;
  const auto all = static_cast<int>(model.triangles.size());
  const int most = (build.triangles > 0 ? std::min(build.triangles, all) : all) >> level;
  products.written = simplify_model(model, std::max(most, 1));
  const size_t left = products.written->triangles.size();
  if (left > static_cast<size_t>(most))
    products.warnings.push_back(std::to_string(left) + " triangles are left where " +
                                std::to_string(most) +
                                " were wanted: seams and outlines need them; fewer --vertices "
                                "make fewer");
}

Status add_models(Products& products, const BuildArguments& build, const SceneInput& input,
                  const relief::Relief& relief, const RunContext& context) {
  ReliefArguments arguments = build.relief;
  arguments.solid_options.size = build.size_mm;
  const auto put = [&](const std::vector<std::string>& names) -> Status {
    auto made = make_model(relief, input, arguments, context);
    if (!made) return made.error();
    const auto& [model, drawing] = products.made.emplace(std::move(*made)).drawn;
    // A solid is in mm already.
    const double size = products.made->solid ? longest_side(model) : build.size_mm;
    const bool standing = arguments.solid && stands(arguments.solid_options);
    // The finest last, which the report tells of.
    for (int level = names.empty() ? -1 : build.levels - 1; level >= 0; --level) {
      make_level(products, build, level);
      const Model& written = products.written ? *products.written : model;
      const double share = longest_side(written) / longest_side(model);
      for (const std::string& name : names) {
        auto files = export_model(written, drawing, level_name(name, level),
                                  {share * size, standing, build.filaments, build.slicer});
        if (!files) return files.error();
        std::move(files->begin(), files->end(), std::back_inserter(products.files));
        if (context.cancelled()) return interrupted_error();
      }
    }
    return Done{};
  };
  const auto [printed, shown] = sort_models(build);
  if (!shown.empty() || !build.preview.empty() || !build.carve_map.empty()) {
    if (Status status = put(shown); !status) return status;
    if (Status status = add_preview(products, build, context); !status) return status;
    if (Status status = add_carve_map(products, build); !status) return status;
  }
  if (printed.empty()) return Done{};
  if (!arguments.visibility) arguments.visibility = Visibility::relief;
  return put(printed);
}

Result<ReliefMaps> make_maps(const BuildArguments& build, const Scene& scene,
                             const relief::Relief& relief, const RunContext& context) {
  const ImageSize size = fitted_size(scene.width, scene.height, build.map_size);
  return relief::rasterize_relief(relief.layers, relief.inflation, relief.ordering, scene,
                                  size.width, size.height, context);
}

Status add_maps(Products& products, const BuildArguments& build, const Scene& scene,
                const relief::Relief& relief, const RunContext& context) {
  if (build.normal_map.empty() && build.depth_map.empty() && build.part_map.empty() &&
      build.occlusion_map.empty())
    return Done{};
  const auto maps = make_maps(build, scene, relief, context);
  if (!maps) return maps.error();
  if (!build.normal_map.empty())
    if (Status s = add(products, build.normal_map, encode_normal_map(*maps, build.normal_y_down));
        !s)
      return s;
  if (!build.depth_map.empty())
    if (Status s = add(products, build.depth_map, encode_depth_map(*maps)); !s) return s;
  if (!build.part_map.empty())
    if (Status s = add(products, build.part_map, encode_part_map(*maps)); !s) return s;
  if (!build.occlusion_map.empty()) {
    const double pixel = scene.width / maps->height.width;
    const Image8 open = share_image(relief::ambient_occlusion(*maps, pixel));
    if (Status s = add(products, build.occlusion_map, encode_png(open)); !s) return s;
  }
  return Done{};
}

Status add_convergence(Products& products, const BuildArguments& build, const Scene& scene,
                       const relief::Relief& relief, const RunContext& context) {
  if (build.convergence.empty()) return Done{};
  return add(products, build.convergence, draw_convergence(relief, scene, context));
}

std::string summary(const relief::Relief& relief) {
  return std::to_string(relief.layers.node_vertex.size()) + " vertices, " +
         std::to_string(relief.ordering.equalities) + " equalities, " +
         std::to_string(relief.ordering.inequalities) + " inequalities, " +
         std::to_string(relief.ordering.report.active) + " active";
}

void print_files(const BuildArguments& build, const Products& products) {
  if (build.print_report) return;
  for (const OutputFile& file : products.files)
    print_result(file.path.string(), build.common.quiet);
}

std::vector<std::string> relief_warnings(const relief::Relief& relief) {
  std::vector<std::string> warnings = relief.layers.warnings;
  if (relief.nonlinear.status == SolveStatus::iteration_limit)
    warnings.push_back(
        "the non-linear method did not converge; the relief keeps its order but is not the best");
  return warnings;
}

/// What is to be said of a solid. All figures hang over, which is in the report.
std::vector<std::string> solid_warnings(const Products& products,
                                        const std::vector<PrintFinding>& findings, double nozzle) {
  std::vector<std::string> warnings;
  if (findings.empty()) return warnings;
  const double size = longest_side(products.made->drawn.model);
  for (const PrintFinding& finding : findings)
    if (finding.trouble != PrintTrouble::overhang)
      warnings.push_back(describe(finding, nozzle, size));
  return warnings;
}

std::vector<std::string> joined(std::vector<std::string> warnings,
                                const std::vector<std::string>& more) {
  warnings.insert(warnings.end(), more.begin(), more.end());
  return warnings;
}

/// The options of the reconstruction, with what the outputs need besides: what lies hidden is
/// placed where a model shows it.
ReliefArguments relief_arguments(const BuildArguments& build) {
  ReliefArguments relief = build.relief;
  if (!relief.visibility && sort_models(build).shown.empty() && build.preview.empty())
    relief.visibility = Visibility::relief;
  if (!build.convergence.empty())
    relief.options.nonlinear.snapshots = convergence_steps(relief.options.nonlinear.max_iterations);
  return relief;
}

}  // namespace

Status run_build(const BuildArguments& build, Interruption& interruption) {
  const Stopwatch total;
  const auto outputs = planned_outputs(build);
  if (Status status = check_outputs(outputs, {build.common.input}); !status) return status;
  if (Status status = check_cost(build.relief.options, build.common.quiet); !status) return status;
  const auto file = read_input(build.common.input);
  if (!file) return file.error();
  std::optional<Progress> progress(build.common.quiet);
  RunContext context{interruption.flag()};
  progress->watch(context);
  auto input = start_scene(*file, build.common.connect, context);
  if (!input) return input.error();
  if (Status status = check_outputs(outputs, input->files); !status) return status;
  const double read_time = total.milliseconds();

  Products products;
  const auto relief = reconstruct(*input, relief_arguments(build), context);
  print_warnings(input->warnings, build.common.quiet);
  if (!relief) return relief.error();
  const Stopwatch exporting;
  if (Status s = finish_drawing(*file, *input); !s) return s;
  if (Status s = add_models(products, build, *input, *relief, context); !s) return s;
  if (Status s = add_maps(products, build, input->scene, *relief, context); !s) return s;
  if (Status s = add_convergence(products, build, input->scene, *relief, context); !s) return s;
  if (!build.overlay.empty())
    if (Status s =
            add(products, build.overlay, draw_overlay(input->scene, {}, input->drawing.rgba));
        !s)
      return s;
  progress.reset();

  const double nozzle = build.relief.nozzle;
  const auto findings =
      products.made ? print_findings(*products.made, build.relief) : std::vector<PrintFinding>{};
  const std::vector<std::string> warnings =
      joined(joined(relief_warnings(*relief), solid_warnings(products, findings, nozzle)),
             products.warnings);
  const std::string report = write_report(
      {build.common.input,
       input->scene,
       *relief,
       build.relief.options.nonlinear,
       written_model(products),
       products.made ? products.made->solid : std::nullopt,
       findings,
       {{"read", read_time}, {"export", exporting.milliseconds()}, {"total", total.milliseconds()}},
       joined(input->warnings, warnings)});
  if (!build.report.empty()) products.files.push_back({build.report, bytes_of(report)});
  // A report that nobody gets must not leave a model behind.
  if (build.print_report) print_result(report, false);
  if (Status status = flush_results(); !status) return status;
  if (Status status = save(products.files, input->files, interruption); !status) return status;
  print_warnings(warnings, build.common.quiet);
  for (const std::string& line : input->understood) print_note(line, build.common.quiet);
  print_note(summary(*relief), build.common.quiet);
  print_files(build, products);
  return Done{};
}

}  // namespace relievo::cli

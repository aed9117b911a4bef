#include "apps/cli/build_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "api/inputs.h"
#include "apps/cli/cost.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/pictures.h"
#include "apps/cli/pixel_art.h"
#include "apps/cli/reconstruct.h"
#include "apps/cli/report.h"
#include "io/files/number_text.h"
#include "io/image/png.h"
#include "io/maps/encode_maps.h"
#include "io/mesh/placement.h"
#include "kernel/base/stopwatch.h"
#include "kernel/image/image_size.h"
#include "lod/simplify_model.h"
#include "relief/maps/ambient_occlusion.h"
#include "relief/maps/relief_maps.h"
#include "relievo/export.h"
#include "relievo/maps.h"
#include "relievo/pixel_art.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

constexpr int usual_map_side = 2048;  ///< px

/// The results of a build.
struct Products {
  Outputs outputs;
  std::optional<MadeModel> made;
  std::optional<Model> written;        ///< the level of detail written last, if not `made` itself
  std::vector<std::string> summaries;  ///< one for each model
  std::vector<std::string> warnings;
};

/// A way to make models.
struct Making {
  bool solid = false;
  Ink ink = Ink::shell;
};

/// Returns the treatment of contours in pictures.
Ink pictured_ink(const BuildArguments& build) { return build.relief.ink.value_or(Ink::shell); }

/// Selects the models that are solids if `solid`, or the surfaces.
std::vector<std::string> models_of(const BuildArguments& build, bool solid) {
  std::vector<std::string> names;
  for (const std::string& name : build.models) {
    const bool made_solid =
        is_for_print(name) ? prints_solids(build.relief) : build.relief.solid.value_or(false);
    if (made_solid == solid) names.push_back(name);
  }
  return names;
}

constexpr Making ways_to_make[] = {{false, Ink::paint}, {false, Ink::none}, {false, Ink::shell},
                                   {true, Ink::paint},  {true, Ink::none},  {true, Ink::shell}};

/// Selects the models that are made in one way.
std::vector<std::string> models_of(const BuildArguments& build, Making making) {
  std::vector<std::string> names = models_of(build, making.solid);
  std::erase_if(names, [&](const std::string& name) {
    return build.relief.ink.value_or(usual_ink(name)) != making.ink;
  });
  return names;
}

const Model* written_model(const Products& products) {
  if (products.written) return &*products.written;
  return products.made ? &products.made->drawn.model : nullptr;
}

/// Simplifies the model to a level of detail, if the options ask for that. A model of one mesh is
/// named after the file `name`.
void make_level(Products& products, const BuildArguments& build, int level,
                const std::string& name) {
  if (build.triangles == 0 && build.levels == 1 && !build.one_mesh) return;
  const Model& made = products.made->drawn.model;
  Model model = build.one_mesh ? unite_parts(made, fs::path(name).stem().string()) : made;
  const auto all = static_cast<int>(model.all_triangles());
  const int most = (build.triangles > 0 ? std::min(build.triangles, all) : all) >> level;
  products.written = simplify_model(model, std::max(most, 1));
  const size_t left = products.written->all_triangles();
  if (left > static_cast<size_t>(most))
    products.warnings.push_back("the model keeps " + std::to_string(left) + " triangles, not " +
                                std::to_string(most) +
                                ": its seams and outlines need them; use fewer --vertices");
}

/// Formats a count as "143,782".
std::string grouped(size_t number) {
  std::string text = std::to_string(number);
  for (size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

/// Describes a model whose longest side is `size` mm: "wolf.glb: 13 parts, 143,782 triangles,
/// 100 x 80 x 31 mm".
std::string summary(const std::string& name, size_t parts, const Model& model, double size) {
  const Box3 box = extent(model);
  const double scale = size / longest_side(model);
  const auto side = [scale](double length) {
    const double mm = scale * length;
    return shortest_text(mm < 10 ? std::round(10 * mm) / 10 : std::round(mm));
  };
  return name + ": " + counted(parts, "part") + ", " + grouped(model.all_triangles()) +
         " triangles, " + side(box.max.x - box.min.x) + " x " + side(box.max.y - box.min.y) +
         " x " + side(box.max.z - box.min.z) + " mm";
}

/// Returns the longest side of the texture of a level of detail, px; 0 for the drawing's own.
int texture_size(const BuildArguments& build, const Drawing& drawing, int level) {
  if (level == 0) return build.texture_size;
  const int own = std::max(drawing.rgba.width, drawing.rgba.height);
  const int finest = build.texture_size > 0 ? std::min(build.texture_size, own) : own;
  return std::max(finest >> level, least_texture_size);
}

/// Makes a surface or a solid of the relief and adds its files of the given names.
Status add_models(Products& products, const BuildArguments& build, Making making,
                  const std::vector<std::string>& names, const SceneInput& input,
                  const relief::Relief& relief, const RunContext& context) {
  ReliefArguments arguments = build.relief;
  const bool solid = making.solid;
  arguments.solid = solid;
  arguments.solid_options.size = build.size_mm;
  auto made = make_model(relief, input, arguments, making.ink, context);
  if (!made) return made.error();
  const auto& [model, drawing] = products.made.emplace(std::move(*made)).drawn;
  // A solid is in mm already.
  const double size = solid ? longest_side(model) : build.size_mm;
  const bool standing = solid && stands(arguments.solid_options);
  // The report describes the finest level, so it comes last.
  for (int level = names.empty() ? -1 : build.levels - 1; level >= 0; --level) {
    make_level(products, build, level, names.front());
    const Model& written = products.written ? *products.written : model;
    const double share = longest_side(written) / longest_side(model);
    for (const std::string& name : names) {
      const std::string file = level_name(name, level);
      const ExportOptions options = {
          share * size,    build.grounded,  texture_size(build, drawing, level),
          standing,        build.filaments, build.slicer,
          build.relief.ink};
      auto files = export_model(written, drawing, file, options);
      if (!files) return files.error();
      std::move(files->begin(), files->end(), std::back_inserter(products.outputs.files));
      products.summaries.push_back(summary(file, input.scene.parts.size(), written, share * size));
      if (context.cancelled()) return interrupted_error();
    }
  }
  return Done{};
}

/// Adds the pictures of the model that was made last.
Status add_pictures(Products& products, const BuildArguments& build, const RunContext& context) {
  const relief::DrawnModel& drawn = products.made->drawn;
  products.outputs.add(build.preview, [&] {
    RenderArguments picture;
    picture.size = build.preview_size;
    return draw_picture(drawn.model, drawn.drawing, picture, context);
  });
  products.outputs.add(build.carve_map, [&] {
    return encode_carve_map(drawn.model, build.px_per_mm, build.relief.solid_options.thickness);
  });
  return products.outputs.status;
}

/// Adds the surfaces, then the solids. Pictures show a solid if the options ask for one.
Status add_models(Products& products, const BuildArguments& build, const SceneInput& input,
                  const relief::Relief& relief, const RunContext& context) {
  const bool pictures = !build.preview.empty() || !build.carve_map.empty();
  for (const Making making : ways_to_make) {
    const std::vector<std::string> names = models_of(build, making);
    const bool pictured = pictures && build.relief.solid.value_or(false) == making.solid &&
                          making.ink == pictured_ink(build);
    if (names.empty() && !pictured) continue;
    if (Status s = add_models(products, build, making, names, input, relief, context); !s) return s;
    if (!pictured) continue;
    if (Status s = add_pictures(products, build, context); !s) return s;
  }
  return Done{};
}

Result<ReliefMaps> make_maps(const BuildArguments& build, const SceneInput& input,
                             const relief::Relief& relief, const RunContext& context) {
  const Scene& scene = input.scene;
  const ImageSize size =
      fitted_size(scene.width, scene.height,
                  build.map_size > 0 ? build.map_size : map_side(input.drawing, usual_map_side));
  return relief::rasterize_relief({relief.layers, relief.inflation, relief.ordering, scene},
                                  size.width, size.height, context);
}

Status add_maps(Outputs& outputs, const BuildArguments& build, const SceneInput& input,
                const relief::Relief& relief, const RunContext& context) {
  if (build.normal_map.empty() && build.depth_map.empty() && build.part_map.empty() &&
      build.occlusion_map.empty())
    return Done{};
  const auto maps = make_maps(build, input, relief, context);
  if (!maps) return maps.error();
  outputs.add(build.normal_map, [&] { return encode_normal_map(*maps, build.normal_y_down); });
  outputs.add(build.depth_map, [&] { return encode_depth_map(*maps); });
  outputs.add(build.part_map, [&] { return encode_part_map(*maps); });
  outputs.add(build.occlusion_map, [&] {
    const double pixel = input.scene.width / maps->height.width;
    return encode_png(share_image(relief::ambient_occlusion(*maps, pixel)));
  });
  return outputs.status;
}

void print_outcome(const BuildArguments& build, const SceneInput& input, const Products& products) {
  print_warnings(products.warnings);
  for (const std::string& line : input.understood) print_note(line);
  for (const std::string& line : products.summaries) print_note(line);
  if (products.summaries.empty())
    print_note(build.common.input + ": " + counted(input.scene.parts.size(), "part"));
  if (build.print_report) return;
  for (const OutputFile& file : products.outputs.files) print_result(file.path.string());
}

/// Returns the options of the reconstruction. Hidden parts are placed only if a model shows them.
ReliefArguments relief_arguments(const BuildArguments& build) {
  ReliefArguments relief = build.relief;
  if (!relief.visibility && models_of(build, false).empty() && build.preview.empty())
    relief.visibility = Visibility::relief;
  if (!build.convergence.empty())
    relief.options.nonlinear.snapshots = convergence_steps(relief.options.nonlinear.max_iterations);
  return relief;
}

/// Makes all outputs but the report.
Result<Products> make_products(const BuildArguments& build, const InputFile& file,
                               SceneInput& input, const relief::Relief& relief,
                               const RunContext& context) {
  Products products;
  if (Status s = finish_drawing(file, input); !s) return s.error();
  settle_pixel_art(build.common, input.drawing);
  if (build.texture_size > 0 && input.drawing.pixel_art > 0)
    products.warnings.emplace_back(
        "the texture of pixel art keeps its size: averages would be further colours; to reduce it "
        "all the same, add --pixel-art no");
  if (Status s = add_models(products, build, input, relief, context); !s) return s.error();
  Outputs& outputs = products.outputs;
  if (Status s = add_maps(outputs, build, input, relief, context); !s) return s.error();
  outputs.add(build.convergence, [&] { return draw_convergence(relief, input.scene, context); });
  outputs.add(build.overlay, [&] { return draw_overlay(input.scene, {}, input.drawing.rgba); });
  if (!outputs.status) return outputs.status.error();
  return products;
}

/// Collects the warnings about the relief, the solid and the models, in this order. Overhangs are
/// only in the report, since every figure has some.
std::vector<std::string> all_warnings(const relief::Relief& relief, const Products& products,
                                      const std::vector<PrintFinding>& findings) {
  std::vector<std::string> warnings = relief.layers.warnings;
  if (relief.nonlinear.status == SolveStatus::iteration_limit)
    warnings.push_back(
        "the non-linear method did not converge: the depth order holds, but the shape is not the "
        "best possible");
  for (const PrintFinding& finding : findings)
    if (finding.trouble != PrintTrouble::overhang) warnings.push_back(describe(finding));
  warnings.insert(warnings.end(), products.warnings.begin(), products.warnings.end());
  return warnings;
}

/// Writes the report, and completes the warnings of `products`.
std::string finish_report(const BuildArguments& build, const SceneInput& input,
                          const relief::Relief& relief, Products& products,
                          std::vector<relief::StageTime> times) {
  std::vector<PrintFinding> findings;
  if (products.made) findings = print_findings(*products.made, build.relief);
  products.warnings = all_warnings(relief, products, findings);
  std::vector<std::string> warnings = input.warnings;
  warnings.insert(warnings.end(), products.warnings.begin(), products.warnings.end());
  return write_report({build.common.input, input.scene, relief, build.relief.options.nonlinear,
                       written_model(products), products.made ? products.made->solid : std::nullopt,
                       findings, std::move(times), warnings});
}

}  // namespace

Status run_build(const BuildArguments& build, Interruption& interruption) {
  const Stopwatch total;
  const auto outputs = planned_outputs(build);
  if (Status status = check_outputs(outputs, {build.common.input}); !status) return status;
  if (Status status = check_cost(build.relief.options); !status) return status;
  const auto file = read_input(build.common.input);
  if (!file) return file.error();
  std::optional<Progress> progress(std::in_place);
  const RunContext context = progress->context(interruption.flag());
  auto input = start_scene(*file, build.common.connect, context);
  if (!input) return input.error();
  if (Status status = check_outputs(outputs, input->files); !status) return status;
  const double read_time = total.milliseconds();

  const auto relief = reconstruct(*input, relief_arguments(build), context);
  print_warnings(input->warnings);
  if (!relief) return relief.error();
  const Stopwatch exporting;
  auto products = make_products(build, *file, *input, *relief, context);
  if (!products) return products.error();
  progress.reset();

  const std::string report = finish_report(
      build, *input, *relief, *products,
      {{"read", read_time}, {"export", exporting.milliseconds()}, {"total", total.milliseconds()}});
  products->outputs.add(build.report, [&] { return bytes_of(report); });
  // No model is written if the report cannot be printed.
  if (build.print_report) std::fputs(report.c_str(), stdout);
  if (Status status = flush_results(); !status) return status;
  if (Status status = save(products->outputs, input->files, interruption); !status) return status;
  print_outcome(build, *input, *products);
  return Done{};
}

}  // namespace relievo::cli

#include "research/compare/compare_command.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "api/inputs.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/pictures.h"
#include "io/files/paths.h"
#include "io/image/decode_image.h"
#include "kernel/base/stopwatch.h"
#include "relievo/export.h"
#include "relievo/maps.h"
#include "research/rivals/measure.h"

namespace relievo::research {

namespace {

std::vector<std::filesystem::path> planned_outputs(const CompareArguments& compare) {
  cli::BuildArguments build;
  build.models = compare.models;
  build.preview = compare.preview;
  build.normal_map = compare.normal_map;
  build.depth_map = compare.depth_map;
  build.report = compare.report;
  return cli::planned_outputs(build);
}

/// The model of a method, and the time it took.
struct Compared {
  relief::LayeredMesh joined;
  Model model;
  double mesh_ms = 0;
  double method_ms = 0;
};

Result<Compared> run_method(const Scene& scene, const CompareArguments& compare,
                            const RivalOptions& options, const RunContext& context) {
  Compared result;
  const Stopwatch meshing;
  auto joined = layer_for_rivals(scene, compare.relief.options.layers, context);
  if (!joined) return joined.error();
  result.joined = std::move(*joined);
  result.mesh_ms = meshing.milliseconds();
  const Stopwatch solving;
  auto model = find_rival(compare.method)->reconstruct({scene, result.joined, options}, context);
  if (!model) return model.error();
  result.model = std::move(*model);
  result.method_ms = solving.milliseconds();
  return result;
}

nlohmann::ordered_json distribution(const std::vector<double>& sorted) {
  return {{"count", sorted.size()},
          {"median", quantile(sorted, 0.5)},
          {"nine_tenths", quantile(sorted, 0.9)},
          {"most", quantile(sorted, 1)}};
}

std::string write_measures(const Measures& measures, const Compared& compared,
                           const CompareArguments& compare) {
  nlohmann::ordered_json json;
  json["input"] = compare.common.input;
  json["method"] = compare.method;
  json["source"] = find_rival(compare.method)->source;
  json["vertices"] = compared.model.positions.size();
  json["faces"] = compared.model.triangles.size();
  json["slope_jump_degrees"] = distribution(measures.slope_jumps);
  json["height_jump_px"] = distribution(measures.height_jumps);
  json["pit_per_join_length"] = distribution(measures.pits);
  json["contour_iou"] = measures.contour_iou;
  json["milliseconds"] = {{"mesh", compared.mesh_ms}, {"method", compared.method_ms}};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Status add_maps(const Compared& compared, const CompareArguments& compare, cli::Outputs& outputs,
                const RunContext& context) {
  if (compare.normal_map.empty() && compare.depth_map.empty()) return Done{};
  const auto probe = FrontProbe::build(compared.model, context);
  if (!probe) return probe.error();
  const ReliefMaps maps = probe->maps(compare.map_size);
  outputs.add(compare.normal_map, [&] { return encode_normal_map(maps); });
  outputs.add(compare.depth_map, [&] { return encode_depth_map(maps); });
  return outputs.status;
}

Result<cli::Outputs> make_outputs(const Compared& compared, const Drawing& drawing,
                                  const CompareArguments& compare, const RunContext& context) {
  cli::Outputs outputs;
  for (const std::string& name : compare.models) {
    auto model = export_model(compared.model, drawing, name);
    if (!model) return model.error();
    std::move(model->begin(), model->end(), std::back_inserter(outputs.files));
  }
  if (Status s = add_maps(compared, compare, outputs, context); !s) return s.error();
  outputs.add(compare.preview, [&] {
    return cli::draw_picture(compared.model, drawing, cli::RenderArguments{}, context);
  });
  if (!compare.report.empty()) {
    const auto measures = measure(compared.model, compared.joined, compare.map_size, context);
    if (!measures) return measures.error();
    outputs.add(compare.report,
                [&] { return bytes_of(write_measures(*measures, compared, compare)); });
  }
  return outputs;
}

Result<Image8> read_mask(const std::string& name) {
  const auto file = read_input(name);
  if (!file) return file.error();
  auto mask = decode_image(file->bytes);
  return mask ? std::move(mask) : in_file(mask.error(), name);
}

}  // namespace

Status run_compare(const CompareArguments& compare, cli::Interruption& interruption) {
  const auto outputs = planned_outputs(compare);
  if (Status s = cli::check_outputs(outputs, {compare.common.input}); !s) return s;
  const auto input = read_input(compare.common.input);
  if (!input) return input.error();
  cli::Progress progress;
  const RunContext context = progress.context(interruption.flag());
  auto loaded = load_scene(*input, compare.common.connect, context);
  if (!loaded) return loaded.error();
  RivalOptions options = compare.options;
  if (!compare.graft_mask.empty()) {
    auto mask = read_mask(compare.graft_mask);
    if (!mask) return mask.error();
    options.graft_mask = std::move(*mask);
    loaded->files.emplace_back(compare.graft_mask);
  }
  if (Status s = cli::check_outputs(outputs, loaded->files); !s) return s;
  cli::print_warnings(loaded->warnings);
  const auto compared = run_method(loaded->scene, compare, options, context);
  if (!compared) return compared.error();
  const auto made = make_outputs(*compared, loaded->drawing, compare, context);
  if (!made) return made.error();
  if (Status s = cli::save(*made, loaded->files, interruption); !s) return s;
  for (const OutputFile& file : made->files) cli::print_result(file.path.string());
  return Done{};
}

}  // namespace relievo::research

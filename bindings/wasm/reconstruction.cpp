#include "bindings/wasm/reconstruction.h"

#include <algorithm>
#include <iterator>

#include "bindings/wasm/js_values.h"
#include "io/mesh/obj_encode.h"
#include "io/mesh/placement.h"
#include "io/mesh/threemf_encode.h"
#include "io/scene/scene_json.h"
#include "relief/finish/finish_model.h"
#include "relief/finish/hidden_patches.h"
#include "relievo/export.h"
#include "relievo/pixel_art.h"
#include "solid/check_print.h"

namespace relievo::wasm {
namespace {

using emscripten::val;

BuildOptions to_options(const val& options) {
  BuildOptions build;
  if (options["method"].as<std::string>() == "nonlinear") build.method = Method::nonlinear;
  build.vertices = options["vertices"].as<int>();
  build.edge = options["edge"].as<double>();
  build.glue = options["glue"].as<bool>();
  build.rho = options["rho"].as<double>();
  build.alpha0 = options["alpha0"].as<double>();
  build.lambda_bnd = options["lambdaBnd"].as<double>();
  build.lambda_shift = options["lambdaShift"].as<double>();
  return build;
}

void set_picture(val& result, const Image8& rgba) {
  result.set("rgba", to_js(rgba.pixels));
  result.set("width", rgba.width);
  result.set("height", rgba.height);
}

val report(const BuildReport& report) {
  val times = val::object();
  for (const auto& [stage, milliseconds] : report.milliseconds) times.set(stage, milliseconds);
  val what = val::object();
  what.set("nodes", report.vertices);
  what.set("faces", report.faces);
  what.set("equalities", report.equalities);
  what.set("inequalities", report.inequalities);
  what.set("active", report.active);
  what.set("maxViolation", report.max_violation);
  what.set("overlapWorst", report.worst_overlap);
  what.set("energy", report.energy);
  what.set("converged", report.converged);
  what.set("times", times);
  what.set("warnings", to_js(report.warnings));
  return what;
}

template <class Choices, class Choice>
Status choose(const Choices& choices, const std::string& option, const val& name, Choice& chosen) {
  for (const auto& [one, choice] : choices)
    if (name.as<std::string>() == one) {
      chosen = choice;
      return Done{};
    }
  return Error{ErrorCode::usage, "has an unknown value", option};
}

Status set_option(const std::string& name, const val& value, SolidOptions& options) {
  if (name == "back") return choose(back_sides, name, value, options.back);
  if (name == "base") return choose(base_shapes, name, value, options.base);
  const auto length = std::find_if(std::begin(solid_lengths), std::end(solid_lengths),
                                   [&name](const SolidLength& one) { return name == one.name; });
  if (length != std::end(solid_lengths))
    options.*length->value = value.as<double>();
  else if (name == "detail")
    options.detail = value.as<bool>();
  else
    return Error{ErrorCode::usage, "there is no such option", name};
  return Done{};
}

/// Reads the given options. Others have their defaults.
Result<SolidOptions> to_solid_options(const val& given) {
  SolidOptions options;
  const val names = val::global("Object").call<val>("keys", given);
  for (const auto& name : emscripten::vecFromJSArray<std::string>(names))
    if (Status status = set_option(name, given[name], options); !status) return status.error();
  return options;
}

Visibility visibility_named(const std::string& name) {
  if (name == "orbit") return Visibility::orbit;
  return name == "all" ? Visibility::all : Visibility::relief;
}

Field field_named(const std::string& name) {
  if (name == "inflation") return Field::inflation;
  return name == "shift" ? Field::shift : Field::relief;
}

val runs(const std::vector<ModelPart>& parts, const relief::HiddenPatches& hidden) {
  std::vector<int> dressed(parts.size(), 0);
  for (const relief::HiddenPatch& patch : hidden.patches)
    dressed[patch.part] = parts[patch.part].hidden_count;
  val list = val::array();
  for (size_t i = 0; i < parts.size(); ++i) {
    val run = val::object();
    run.set("id", parts[i].id);
    run.set("firstTriangle", parts[i].first_triangle);
    run.set("triangleCount", parts[i].triangle_count);
    run.set("hiddenCount", dressed[i]);
    list.set(i, run);
  }
  return list;
}

val corners_of(const std::vector<std::array<int, 3>>& triangles) {
  std::vector<uint32_t> corners;
  corners.reserve(3 * triangles.size());
  for (const std::array<int, 3>& triangle : triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  return wasm::to_js(corners);
}

val to_js(const InkMesh& ink) {
  val mesh = val::object();
  mesh.set("positions", wasm::to_js(flatten(ink.positions)));
  mesh.set("uvs", wasm::to_js(flatten(ink.uvs)));
  mesh.set("triangles", corners_of(ink.triangles));
  return mesh;
}

/// Returns the treatment of contours in a file, where a width of 0 stands for none.
Ink ink_in(const std::string& file, double ink_width) {
  const Ink usual = usual_ink(file);
  return usual == Ink::shell && ink_width == 0 ? Ink::none : usual;
}

/// `drawing`: the one on the model.
val to_js(const Model& model, const relief::HiddenPatches& hidden, const Drawing& drawing) {
  val surface = val::object();
  surface.set("positions", wasm::to_js(flatten(model.positions)));
  surface.set("normals", wasm::to_js(flatten(model.normals)));
  surface.set("uvs", wasm::to_js(flatten(model.uvs)));
  surface.set("triangles", corners_of(model.triangles));
  surface.set("colors", wasm::to_js(relief::hidden_colours(model, hidden)));
  surface.set("parts", runs(model.parts, hidden));
  surface.set("pixelArt", drawing.pixel_art > 0);
  if (!model.ink.triangles.empty()) surface.set("ink", to_js(model.ink));
  return surface;
}

val findings(const Solid& solid, bool standing) {
  val list = val::array();
  for (const PrintFinding& finding :
       check_print(solid.model, solid.facts.loose, usual_nozzle, standing)) {
    val entry = val::object();
    entry.set("trouble", std::string(name(finding.trouble)));
    entry.set("part", finding.part);
    entry.set("measure", finding.measure);
    entry.set("enough", finding.enough);
    list.call<void>("push", entry);
  }
  return list;
}

/// Returns a model as files; as "3mf", the files of the package, which the page packs.
Result<std::vector<ArchiveEntry>> encode_as(const std::string& format, const std::string& name,
                                            const Model& model, const Drawing& drawing,
                                            const ExportOptions& options) {
  if (format == "3mf")
    return threemf_entries(model, drawing.rgba.empty() ? nullptr : &drawing, options);
  const std::string stem = format == "obj" ? obj_file_name(name) : name;
  auto files = export_model(model, drawing, stem + "." + format, options);
  if (!files) return files.error();
  std::vector<ArchiveEntry> entries;
  for (OutputFile& file : *files) entries.push_back({file.path.string(), std::move(file.bytes)});
  return entries;
}

val to_js(const Result<std::vector<ArchiveEntry>>& files) {
  if (!files) return failure(files.error());
  val list = val::array();
  for (const ArchiveEntry& entry : *files) {
    val file = val::object();
    file.set("name", entry.name);
    file.set("bytes", wasm::to_js(entry.bytes));
    list.call<void>("push", file);
  }
  val result = val::object();
  result.set("files", list);
  return result;
}

}  // namespace

val Reconstruction::build(const std::string& text, const val& options, const val& progress) {
  const auto scene = read_scene(text);
  if (!scene) return failure(scene.error());
  RunContext context;
  val energy = val::undefined();
  context.measured = [&energy](const char*, double value) { energy = val(value); };
  context.progress = [&](const char* stage, double fraction) {
    progress(std::string(stage), fraction, energy);
  };
  const auto built = session_.build(*scene, to_options(options), context);
  return built ? report(*built) : failure(built.error());
}

val Reconstruction::surface(const std::string& visibility, double tolerance,
                            const std::string& field) const {
  ModelOptions options;
  options.visibility = visibility_named(visibility);
  options.rim_tolerance = tolerance;
  const auto model = session_.model(options, field_named(field));
  return model ? to_js(*model, relief::hidden_patches(*model, shown_), shown_)
               : failure(model.error());
}

val Reconstruction::dressed(double tolerance, double ink_width) const {
  ModelOptions options;
  options.rim_tolerance = tolerance;
  auto model = session_.model(options);
  if (!model) return failure(model.error());
  const auto [finished, drawing] = relief::finish_model(
      std::move(*model), texture_, ink_width > 0 ? Ink::shell : Ink::none, ink_width);
  val result = val::object();
  result.set("surface", to_js(finished, relief::HiddenPatches{}, drawing));
  set_picture(result, drawing.rgba);
  return result;
}

val Reconstruction::overlays() const {
  const auto found = session_.lines();
  if (!found) return failure(found.error());
  val overlays = val::object();
  overlays.set("joins", wasm::to_js(found->joins));
  overlays.set("equal", wasm::to_js(found->equal));
  overlays.set("above", wasm::to_js(found->above));
  overlays.set("below", wasm::to_js(found->below));
  overlays.set("ramps", wasm::to_js(found->ramps));
  return overlays;
}

void Reconstruction::set_texture(const val& rgba, int width, int height) {
  texture_ = to_drawing(rgba, width, height);
}

void Reconstruction::set_shown(const val& rgba, int width, int height) {
  shown_ = to_drawing(rgba, width, height);
}

val Reconstruction::solid(const val& options) const {
  const auto chosen = to_solid_options(options);
  if (!chosen) return failure(chosen.error());
  const auto made = session_.solid(*chosen, texture_);
  if (!made) return failure(made.error());
  const Box3 box = extent(made->model);
  const Image8& rgba = made->drawing.rgba;
  val sizes = val::array();
  for (const double side : {box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z})
    sizes.call<void>("push", side);
  val result = val::object();
  Model model = made->model;
  for (Point3& p : model.positions) p.z -= 0.5 * (box.min.z + box.max.z);
  result.set("surface", to_js(model, relief::HiddenPatches{}, made->drawing));
  result.set("size", sizes);
  result.set("volume", made->facts.volume);
  result.set("pieces", made->facts.pieces);
  result.set("findings", findings(*made, stands(*chosen)));
  set_picture(result, rgba);
  return result;
}

val Reconstruction::encode_solid(const std::string& format, const std::string& name,
                                 const val& options, double ink_width) {
  if (Status status = session_.make_exact(); !status) return failure(status.error());
  auto solid = to_solid_options(options);
  if (!solid) return failure(solid.error());
  solid->ink = ink_in("model." + format, ink_width);
  if (ink_width > 0) solid->ink_width = ink_width;
  const auto made = session_.solid(*solid, texture_);
  if (!made) return failure(made.error());
  return to_js(encode_as(format, name, made->model, made->drawing,
                         {.size_mm = longest_side(made->model), .standing = stands(*solid)}));
}

val Reconstruction::encode(const std::string& format, const std::string& name, double size_mm,
                           double ink_width) {
  if (Status status = session_.make_exact(); !status) return failure(status.error());
  if (is_for_print("model." + format)) {
    SolidOptions solid;
    solid.size = size_mm;
    const auto made = session_.solid(solid, texture_);
    if (!made) return failure(made.error());
    return to_js(encode_as(format, name, made->model, made->drawing,
                           {.size_mm = longest_side(made->model)}));
  }
  const auto model = session_.model();
  if (!model) return failure(model.error());
  return to_js(encode_as(format, name, *model, texture_,
                         {.size_mm = size_mm,
                          .ink = ink_in("model." + format, ink_width),
                          .ink_width = ink_width > 0 ? ink_width : 1}));
}

val Reconstruction::map(const std::string& kind, int side, bool green_down) {
  if (Status status = session_.make_exact(); !status) return failure(status.error());
  const auto maps = session_.maps(map_side(shown_, side));
  if (!maps) return failure(maps.error());
  const auto bytes = kind == "normal"  ? encode_normal_map(*maps, green_down)
                     : kind == "depth" ? encode_depth_map(*maps)
                                       : encode_part_map(*maps);
  if (!bytes) return failure(bytes.error());
  val result = val::object();
  result.set("bytes", wasm::to_js(*bytes));
  return result;
}

}  // namespace relievo::wasm

#include "bindings/wasm/reconstruction.h"

#include <algorithm>

#include "bindings/wasm/js_values.h"
#include "io/maps/encode_maps.h"
#include "io/mesh/glb_encode.h"
#include "io/mesh/obj_encode.h"
#include "io/mesh/ply_encode.h"
#include "io/mesh/stl_encode.h"
#include "io/overlay/mesh_lines.h"
#include "io/scene/read_scene.h"
#include "kernel/image/image_size.h"
#include "relief/model/assemble_model.h"
#include "relief/model/hidden_patches.h"
#include "relief/pipeline/keep_field.h"

namespace relievo::wasm {
namespace {

using emscripten::val;

const Error nothing_built = {ErrorCode::usage, "nothing has been built yet", ""};

ReliefOptions to_options(const val& options) {
  ReliefOptions relief;
  if (options["method"].as<std::string>() == "nonlinear") relief.method = Method::nonlinear;
  relief.layers.vertex_budget = options["vertices"].as<int>();
  relief.layers.edge_length = options["edge"].as<double>();
  relief.layers.glue = options["glue"].as<bool>();
  relief.inflation.rho = options["rho"].as<double>();
  relief.inflation.alpha0 = options["alpha0"].as<double>();
  relief.joint.lambda_bnd = options["lambdaBnd"].as<double>();
  relief.joint.lambda_shift = options["lambdaShift"].as<double>();
  return relief;
}

val times(const std::vector<StageTime>& list) {
  val sums = val::object();
  for (const StageTime& time : list) {
    if (time.beside) continue;
    const val before = sums[time.stage];
    sums.set(time.stage, (before.isUndefined() ? 0 : before.as<double>()) + time.milliseconds);
  }
  return sums;
}

val report(const Relief& relief) {
  val what = val::object();
  what.set("nodes", relief.layers.node_vertex.size());
  what.set("faces", relief.layers.faces.size());
  what.set("equalities", relief.ordering.equalities);
  what.set("inequalities", relief.ordering.inequalities);
  what.set("active", relief.ordering.report.active);
  what.set("maxViolation", relief.ordering.max_violation);
  what.set("overlapWorst", relief.overlap_worst);
  what.set("energy", relief.joint.energy.total());
  what.set("converged", relief.joint.status == JointStatus::solved);
  what.set("times", times(relief.times));
  what.set("warnings", to_js(relief.layers.warnings));
  return what;
}

Visibility visibility_named(const std::string& name) {
  if (name == "orbit") return Visibility::orbit;
  return name == "all" ? Visibility::all : Visibility::relief;
}

Field field_named(const std::string& name) {
  if (name == "inflation") return Field::inflation;
  return name == "shift" ? Field::shift : Field::relief;
}

std::vector<float> flatten(const std::vector<Point3>& points) {
  std::vector<float> flat;
  flat.reserve(3 * points.size());
  for (const Point3& p : points)
    for (const double x : {p.x, p.y, p.z}) flat.push_back(static_cast<float>(x));
  return flat;
}

std::vector<float> flatten(const std::vector<Point2>& points) {
  std::vector<float> flat;
  flat.reserve(2 * points.size());
  for (const Point2& p : points)
    for (const double x : {p.x, p.y}) flat.push_back(static_cast<float>(x));
  return flat;
}

val runs(const std::vector<ModelPart>& parts, const HiddenPatches& hidden) {
  std::vector<int> dressed(parts.size(), 0);
  for (const HiddenPatch& patch : hidden.patches)
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

val to_js(const Model& model, const Drawing& drawing) {
  const HiddenPatches hidden = hidden_patches(model, drawing);
  std::vector<uint32_t> corners;
  corners.reserve(3 * model.triangles.size());
  for (const std::array<int, 3>& triangle : model.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  val surface = val::object();
  surface.set("positions", wasm::to_js(flatten(model.positions)));
  surface.set("normals", wasm::to_js(flatten(model.normals)));
  surface.set("uvs", wasm::to_js(flatten(model.uvs)));
  surface.set("triangles", wasm::to_js(corners));
  surface.set("colors", wasm::to_js(hidden_colours(model, hidden)));
  surface.set("parts", runs(model.parts, hidden));
  return surface;
}

/// A list of files under construction; keeps the first error.
class Files {
 public:
  void add(const std::string& name, const Result<Bytes>& bytes) {
    if (bytes)
      add(name, *bytes);
    else if (!error_)
      error_ = bytes.error();
  }
  void add(const std::string& name, const Bytes& bytes) {
    val file = val::object();
    file.set("name", name);
    file.set("bytes", wasm::to_js(bytes));
    list_.call<void>("push", file);
  }
  val finish() const {
    if (error_) return failure(*error_);
    val result = val::object();
    result.set("files", list_);
    return result;
  }

 private:
  val list_ = val::array();
  std::optional<Error> error_;
};

val encode_obj_files(const Model& model, const Drawing* texture, const ObjOptions& options) {
  const auto encoded = encode_obj(model, texture, options);
  if (!encoded) return failure(encoded.error());
  const std::string stem = obj_file_name(options.name);
  Files files;
  files.add(stem + ".obj", encoded->obj);
  files.add(stem + ".mtl", encoded->mtl);
  if (!encoded->png.empty()) files.add(stem + ".png", encoded->png);
  return files.finish();
}

}  // namespace

val Reconstruction::build(const std::string& scene, const val& options, const val& progress) {
  auto read = read_scene(scene);
  if (!read) return failure(read.error());
  const ReliefOptions wanted = to_options(options);
  RunContext context;
  val energy = val::undefined();
  context.measured = [&energy](const char*, double value) { energy = val(value); };
  context.progress = [&](const char* stage, double fraction) {
    progress(std::string(stage), fraction, energy);
  };
  // The non-linear method ends where its tolerance lets it, which depends on where it begins.
  const bool fresh = state_ == State::none || wanted.method == Method::nonlinear;
  if (fresh) session_ = ReliefSession();
  state_ = State::none;
  if (Status status = session_.update(*read, wanted, context); !status)
    return failure(status.error());
  state_ = fresh ? State::exact : State::warm;
  scene_ = std::move(*read);
  options_ = wanted;
  return report(session_.relief());
}

Status Reconstruction::make_exact() {
  if (state_ == State::none) return nothing_built;
  if (state_ == State::exact) return Done{};
  session_ = ReliefSession();
  state_ = State::none;
  if (Status status = session_.update(scene_, options_); !status) return status;
  state_ = State::exact;
  return Done{};
}

val Reconstruction::surface(const std::string& visibility, double tolerance,
                            const std::string& field) const {
  if (state_ == State::none) return failure(nothing_built);
  const Relief& relief = session_.relief();
  ModelOptions options;
  options.visibility = visibility_named(visibility);
  options.rim_tolerance = tolerance;
  const Field wanted = field_named(field);
  Relief one_field;
  if (wanted != Field::relief) {
    one_field.inflation = relief.inflation;
    one_field.ordering = relief.ordering;
    keep_field(one_field, wanted);
  }
  const Relief& shown = wanted == Field::relief ? relief : one_field;
  const auto model =
      assemble_model(relief.layers, shown.inflation, shown.ordering, scene_, options);
  return model ? to_js(*model, shown_) : failure(model.error());
}

val Reconstruction::overlays() const {
  if (state_ == State::none) return failure(nothing_built);
  const MeshLines found = find_mesh_lines(session_.relief().layers, options_.inflation.alpha0);
  val overlays = val::object();
  overlays.set("joins", wasm::to_js(found.joins));
  overlays.set("equal", wasm::to_js(found.equal));
  overlays.set("above", wasm::to_js(found.above));
  overlays.set("below", wasm::to_js(found.below));
  overlays.set("ramps", wasm::to_js(found.ramps));
  return overlays;
}

void Reconstruction::set_texture(const val& rgba, int width, int height) {
  texture_.rgba = width < 1 || height < 1 ? Image8() : to_image(rgba, width, height);
}

void Reconstruction::set_shown(const val& rgba, int width, int height) {
  shown_.rgba = width < 1 || height < 1 ? Image8() : to_image(rgba, width, height);
}

val Reconstruction::encode(const std::string& format, const std::string& name, double size_mm) {
  if (Status status = make_exact(); !status) return failure(status.error());
  const Relief& relief = session_.relief();
  const auto model = assemble_model(relief.layers, relief.inflation, relief.ordering, scene_, {});
  if (!model) return failure(model.error());
  const Drawing* texture = texture_.rgba.empty() ? nullptr : &texture_;
  if (format == "obj") return encode_obj_files(*model, texture, {size_mm, name});
  Files files;
  const std::string file = name + "." + format;
  if (format == "ply") files.add(file, encode_ply(*model, texture, {size_mm, ""}));
  if (format == "stl") files.add(file, encode_stl(*model, size_mm));
  if (format == "glb") files.add(file, encode_glb(*model, texture, size_mm));
  return files.finish();
}

val Reconstruction::map(const std::string& kind, int side, bool green_down) {
  if (Status status = make_exact(); !status) return failure(status.error());
  const Relief& relief = session_.relief();
  const ImageSize size = fitted_size(scene_.width, scene_.height, side);
  const auto maps = rasterize_relief(relief.layers, relief.inflation, relief.ordering, scene_,
                                     size.width, size.height);
  if (!maps) return failure(maps.error());
  const auto bytes = kind == "normal"
                         ? encode_normal_map(*maps, green_down ? GreenAxis::down : GreenAxis::up)
                     : kind == "depth" ? encode_depth_map(*maps)
                                       : encode_part_map(*maps);
  if (!bytes) return failure(bytes.error());
  val result = val::object();
  result.set("bytes", wasm::to_js(*bytes));
  return result;
}

}  // namespace relievo::wasm

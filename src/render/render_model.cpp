#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <thread>

#include "kernel/base/workers.h"
#include "kernel/geometry/box3.h"
#include "kernel/image/compose.h"
#include "relief/finish/finish_model.h"
#include "relief/finish/model_texture.h"
#include "relievo/model.h"
#include "relievo/point.h"
#include "relievo/render.h"
#include "render/ray_scene.h"
#include "render/shading.h"

namespace relievo {
namespace {

constexpr double margin = 0.04;  ///< around the model, of each side of the picture

/// Returns the box of the model along the camera's axes.
Box3 box_along(const Model& model, const Camera& camera) {
  Box3 box;
  for (const std::array<int, 3>& triangle : model.triangles)
    for (const int v : triangle) {
      const Point3 p = model.positions[v];
      box.add({dot(p, camera.right), dot(p, camera.up), dot(p, camera.back)});
    }
  return box;
}

/// Returns a camera turned by yaw and pitch, with the whole model in the picture and a margin
/// around it. Precondition: the model has triangles.
Camera framing_camera(const Model& model, const RenderOptions& options) {
  const double yaw = options.yaw * std::numbers::pi / 180;
  const double pitch = options.pitch * std::numbers::pi / 180;
  Camera camera;
  camera.right = {std::cos(yaw), 0, -std::sin(yaw)};
  camera.back = {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
  camera.up = cross(camera.back, camera.right);
  camera.width = options.width;
  camera.height = options.height;
  const Box3 box = box_along(model, camera);
  const Point3 middle = 0.5 * (box.min + box.max);
  const Point3 sides = box.sides();
  const double room = 1 - 2 * margin;
  camera.centre = from_camera(camera, middle);
  camera.unit = std::max(sides.x / (room * options.width), sides.y / (room * options.height));
  camera.distance = norm(sides);
  return camera;
}

/// Returns the origin of the ray of a point of the picture (px, y down); it runs along
/// -camera.back.
Point3 ray_origin(const Camera& camera, Point2 picture) {
  const double x = camera.unit * (picture.x - 0.5 * camera.width);
  const double y = camera.unit * (0.5 * camera.height - picture.y);
  return camera.centre + from_camera(camera, {x, y, camera.distance});
}

constexpr int max_side = 16384;
constexpr int64_t max_pixels = 100'000'000;
constexpr Rgb clay{0.80, 0.735, 0.665};
constexpr double bounce = 0.15;   ///< share of the surroundings' light reflected by occluders
constexpr uint32_t key_rays = 2;  ///< per sample
/// Lift of rays to the light, of the model's size, above a face that looks away from the light
/// while its smooth normal does not: else they would meet the face's neighbours.
constexpr double terminator_lift = 0.008;

/// All data for rendering a pixel; constant while rows are rendered.
struct Renderer {
  const Model& model;
  const RenderOptions& options;
  RayScene scene;
  Camera camera;
  LightRig rig;
  std::optional<TextureSampler> texture;
  double lift = 0;   ///< of rays above the surface, px
  double reach = 0;  ///< of rays to the surroundings, px
};

bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }
bool is_finite(Point3 p) { return is_finite(Point2{p.x, p.y}) && std::isfinite(p.z); }

Status check_options(const RenderOptions& o, const Drawing* drawing) {
  const auto wrong = [](const char* what) { return Error{ErrorCode::usage, what, "render"}; };
  if (o.width <= 0 || o.height <= 0) return wrong("the picture must have a positive size");
  if (o.width > max_side || o.height > max_side || int64_t{o.width} * o.height > max_pixels)
    return Error{ErrorCode::limit, "the picture is too large", "render"};
  if (!std::isfinite(o.yaw) || !std::isfinite(o.pitch)) return wrong("angles must be finite");
  if (!is_finite(o.light) || norm(o.light) == 0) return wrong("the light needs a direction");
  if (!(o.light_radius >= 0 && o.light_radius <= 60))
    return wrong("the light's radius must be from 0 to 60 degrees");
  if (o.samples < 1 || o.samples > 1024) return wrong("samples must be from 1 to 1024");
  if (o.ambient_rays < 0 || o.ambient_rays > 64) return wrong("ambient rays must be from 0 to 64");
  if (o.window &&
      !(is_finite(o.window->centre) && std::isfinite(o.window->width) && o.window->width > 0))
    return wrong("the window must have a finite centre and a positive width");
  if (o.shading == Shading::textured && (drawing == nullptr || drawing->rgba.empty()))
    return wrong("there is no drawing to show on the model");
  return Done{};
}

Status check_model(const Model& model) {
  if (model.triangles.empty()) return Error{ErrorCode::bad_input, "the model has no triangles", ""};
  for (size_t v = 0; v < model.positions.size(); ++v)
    if (!is_finite(model.positions[v]) || !is_finite(model.normals[v]) || !is_finite(model.uvs[v]))
      return Error{ErrorCode::bad_input, "the model has a vertex that is not finite",
                   "vertex " + std::to_string(v)};
  return Done{};
}

/// Moves the surface in front of the window's centre to the middle of the picture.
void aim(Camera& camera, const RenderWindow& window, const Renderer& renderer) {
  const Model& model = renderer.model;
  const double front = norm(camera.centre) + 2 * camera.distance;
  Point3 target{window.centre.x, model.height - window.centre.y, 0};
  const Point3 origin = target + Point3{0, 0, front};
  if (const auto hit = renderer.scene.first_hit(origin, {0, 0, -1}); hit && !hit->is_ink) {
    const std::array<int, 3>& corners = model.triangles[hit->triangle];
    target.z = (1 - hit->u - hit->v) * model.positions[corners[0]].z +
               hit->u * model.positions[corners[1]].z + hit->v * model.positions[corners[2]].z;
  }
  camera.distance += norm(target - camera.centre);
  camera.centre = target;
  camera.unit = window.width / camera.width;
}

/// Returns the light on a point from all around, including light reflected by occluders.
Rgb ambient_light(const Renderer& renderer, const SurfacePoint& point, uint32_t first_ray) {
  const auto count = static_cast<uint32_t>(renderer.options.ambient_rays);
  if (count == 0) return surroundings(renderer.rig, point.normal);
  const AxisFrame surface = frame_around(point.normal);
  Rgb sum;
  for (uint32_t k = 0; k < count; ++k) {
    const Point3 direction = ambient_direction(surface, even_point(first_ray + k));
    const bool blocked = renderer.scene.blocked(point.ray_origin, direction, renderer.reach);
    sum = sum + (blocked ? bounce : 1.0) * surroundings(renderer.rig, direction);
  }
  return (1.0 / count) * sum;
}

/// Shades a point. `first_key`, `first_ambient`: its runs in the sequences of directions.
Rgb shade(const Renderer& renderer, const SurfacePoint& point, uint32_t first_key,
          uint32_t first_ambient) {
  double diffuse = 0;
  double gloss = 0;
  for (uint32_t k = 0; k < key_rays; ++k) {
    const Point3 to_light = key_direction(renderer.rig, even_point(first_key + k));
    const double cosine = dot(point.normal, to_light);
    if (cosine <= 0) continue;
    const double higher = dot(point.face, to_light) < 0 ? terminator_lift * renderer.reach : 0;
    const Point3 origin = point.ray_origin + higher * point.normal;
    if (renderer.scene.blocked(origin, to_light, renderer.reach)) continue;
    diffuse += cosine / key_rays;
    gloss += highlight(renderer.rig, point.normal, to_light, renderer.camera.back) / key_rays;
  }
  const Rgb albedo = renderer.texture ? renderer.texture->at(point.uv) : clay;
  const Rgb light =
      ambient_light(renderer, point, first_ambient) + diffuse * renderer.rig.key_light;
  return tone_curve(albedo * light + gloss * renderer.rig.key_light);
}

/// Returns the background behind a pixel, or nothing if it is transparent.
std::optional<Rgb> backdrop(const RenderOptions& options, int x, int y) {
  if (options.background == Background::transparent) return std::nullopt;
  if (options.background == Background::white) return Rgb{1, 1, 1};
  const double dx = (x + 0.5) / options.width - 0.5;
  const double dy = (y + 0.5) / options.height - 0.42;
  const double far = std::min(1.0, 2 * (dx * dx + dy * dy));
  return mix({0.90, 0.895, 0.88}, {0.60, 0.60, 0.60}, far);
}

uint8_t to_byte(double unit) {
  return static_cast<uint8_t>(std::lround(255 * std::clamp(unit, 0.0, 1.0)));
}

void render_pixel(const Renderer& renderer, int x, int y, uint8_t* rgba) {
  const auto samples = static_cast<uint32_t>(renderer.options.samples);
  const auto rays = static_cast<uint32_t>(renderer.options.ambient_rays);
  const uint32_t key_begin = samples * key_rays * block_order(x, y, 0);
  const uint32_t ambient_begin = samples * rays * block_order(x, y, 100);
  Rgb sum;
  int hits = 0;
  for (uint32_t s = 0; s < samples; ++s) {
    const Point2 inside = samples == 1 ? Point2{0.5, 0.5} : even_point(s);
    const Point3 origin = ray_origin(renderer.camera, Point2{1.0 * x, 1.0 * y} + inside);
    const auto hit = renderer.scene.first_hit(origin, -1 * renderer.camera.back);
    if (!hit) continue;
    ++hits;
    if (hit->is_ink) {
      sum = sum + renderer.texture->at(texture_place(renderer.model, *hit));
      continue;
    }
    const SurfacePoint point =
        surface_point(renderer.model, *hit, renderer.camera.back, renderer.lift);
    sum = sum + shade(renderer, point, key_begin + s * key_rays, ambient_begin + s * rays);
  }
  const std::optional<Rgb> behind = backdrop(renderer.options, x, y);
  const double coverage = static_cast<double>(hits) / samples;
  const double alpha = coverage + (1 - coverage) * (behind ? 1 : 0);
  if (alpha == 0) return;
  const Rgb premultiplied = (1.0 / samples) * sum + (1 - coverage) * behind.value_or(Rgb{});
  rgba[0] = to_byte(to_srgb(premultiplied.r / alpha));
  rgba[1] = to_byte(to_srgb(premultiplied.g / alpha));
  rgba[2] = to_byte(to_srgb(premultiplied.b / alpha));
  rgba[3] = to_byte(alpha);
}

Result<Image8> render(const Model& model, const Drawing* drawing, const RenderOptions& options,
                      std::optional<double> unit, const RunContext& context) {
  const InkMesh none;
  Result<RayScene> scene =
      RayScene::build(model, options.shading == Shading::textured ? model.ink : none, context);
  if (!scene) return scene.error();
  Renderer renderer{model, options, std::move(*scene), framing_camera(model, options), {}, {}};
  const double size = renderer.camera.distance;
  renderer.lift = 1e-5 * size;
  renderer.reach = size;
  if (options.window) aim(renderer.camera, *options.window, renderer);
  if (unit) renderer.camera.unit = *unit;
  renderer.rig = light_rig(options, renderer.camera);
  if (options.shading == Shading::textured)
    renderer.texture.emplace(relief::model_texture(model, *drawing),
                             model.width / renderer.camera.unit, drawing->pixel_art == 0);

  Image8 picture(options.width, options.height, 4);
  const std::thread::id caller = std::this_thread::get_id();
  run_tasks(options.height, [&](int y) {
    for (int x = 0; x < options.width && !context.cancelled(); ++x)
      render_pixel(renderer, x, y, &picture.at(x, y));
    if (std::this_thread::get_id() == caller)
      context.report("render", static_cast<double>(y + 1) / options.height);
  });
  if (context.cancelled()) return interrupted_error();
  return picture;
}

constexpr std::array<View, 3> sheet_views = {View::front, View::three_quarter, View::side};

/// Finishes the surface for a textured picture; returns nothing if that is done or not needed.
std::optional<relief::DrawnModel> finished(const Model& model, const Drawing* drawing,
                                           const RenderOptions& options) {
  if (!model.unfinished || !drawing || options.shading == Shading::clay) return std::nullopt;
  return relief::finish_model(model, *drawing, options.ink);
}

}  // namespace

Result<Image8> render_model(const Model& model, const Drawing* drawing,
                            const RenderOptions& options, const RunContext& context) {
  if (Status status = check_options(options, drawing); !status) return status.error();
  if (Status status = check_model(model); !status) return status.error();
  if (const auto drawn = finished(model, drawing, options))
    return render(drawn->model, &drawn->drawing, options, std::nullopt, context);
  return render(model, drawing, options, std::nullopt, context);
}

Result<Image8> render_contact_sheet(const Model& model, const Drawing* drawing,
                                    const RenderOptions& options, const RunContext& context) {
  const int count = static_cast<int>(sheet_views.size());
  RenderOptions cell = options;
  cell.window.reset();
  if (Status status = check_options(cell, drawing); !status) return status.error();
  if (int64_t{count} * options.width * options.height > max_pixels)
    return Error{ErrorCode::limit, "the picture is too large", "render"};
  if (Status status = check_model(model); !status) return status.error();
  if (const auto drawn = finished(model, drawing, options))
    return render_contact_sheet(drawn->model, &drawn->drawing, options, context);
  double unit = 0;
  for (const View view : sheet_views)
    unit = std::max(unit, framing_camera(model, seen_from(view, cell)).unit);

  Image8 sheet(count * options.width, options.height, 4);
  for (int i = 0; i < count; ++i) {
    RunContext part = context;
    part.progress = [&context, i](const char* stage, double fraction) {
      context.report(stage, (i + fraction) / count);
    };
    const Result<Image8> picture =
        render(model, drawing, seen_from(sheet_views[i], cell), unit, part);
    if (!picture) return picture.error();
    paste(sheet, i * options.width, 0, *picture);
  }
  return sheet;
}

}  // namespace relievo

#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/shading.h"

namespace relievo {
namespace {

constexpr double margin = 0.04;

/// Bounds of the model along the camera's axes.
struct Bounds {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point3 low{infinity, infinity, infinity};
  Point3 high{-infinity, -infinity, -infinity};
};

Bounds bounds_along(const Model& model, const Camera& camera) {
  Bounds bounds;
  for (const std::array<int, 3>& triangle : model.triangles)
    for (const int v : triangle) {
      const Point3 p = model.positions[v];
      const Point3 q{dot(p, camera.right), dot(p, camera.up), dot(p, camera.back)};
      bounds.low = {std::min(bounds.low.x, q.x), std::min(bounds.low.y, q.y),
                    std::min(bounds.low.z, q.z)};
      bounds.high = {std::max(bounds.high.x, q.x), std::max(bounds.high.y, q.y),
                     std::max(bounds.high.z, q.z)};
    }
  return bounds;
}

}  // namespace

Camera framing_camera(const Model& model, const RenderOptions& options) {
  const double yaw = options.yaw * std::numbers::pi / 180;
  const double pitch = options.pitch * std::numbers::pi / 180;
  Camera camera;
  camera.right = {std::cos(yaw), 0, -std::sin(yaw)};
  camera.back = {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
  camera.up = cross(camera.back, camera.right);
  camera.width = options.width;
  camera.height = options.height;
  const Bounds bounds = bounds_along(model, camera);
  const Point3 middle = 0.5 * (bounds.low + bounds.high);
  const Point3 sides = bounds.high - bounds.low;
  const double room = 1 - 2 * margin;
  camera.centre = from_camera(camera, middle);
  camera.unit = std::max(sides.x / (room * options.width), sides.y / (room * options.height));
  camera.distance = norm(sides);
  return camera;
}

Point3 ray_origin(const Camera& camera, Point2 picture) {
  const double x = camera.unit * (picture.x - 0.5 * camera.width);
  const double y = camera.unit * (0.5 * camera.height - picture.y);
  return camera.centre + from_camera(camera, {x, y, camera.distance});
}

}  // namespace relievo

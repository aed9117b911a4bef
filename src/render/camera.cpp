#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/geometry/box3.h"
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
  const Box3 box = box_along(model, camera);
  const Point3 middle = 0.5 * (box.min + box.max);
  const Point3 sides = box.sides();
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

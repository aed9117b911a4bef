#include "render/surface_point.h"

#include <algorithm>

namespace relievo {
namespace {

/// A smooth normal can look away from a viewer who still sees the flat triangle: it is turned
/// until it just faces them.
Point3 facing(Point3 normal, Point3 back) {
  constexpr double least = 0.02;
  const double cosine = dot(normal, back);
  return cosine >= least ? normal : normalized(normal + (least - cosine) * back);
}

}  // namespace

SurfacePoint surface_point(const Model& model, const RayHit& hit, Point3 back, double lift) {
  const std::array<int, 3>& corners = model.triangles[hit.triangle];
  const std::array<double, 3> weights = {1 - hit.u - hit.v, hit.u, hit.v};
  Point3 position;
  Point3 smooth;
  SurfacePoint point;
  for (size_t k = 0; k < 3; ++k) {
    position = position + weights[k] * model.positions[corners[k]];
    smooth = smooth + weights[k] * model.normals[corners[k]];
    point.uv = point.uv + weights[k] * model.uvs[corners[k]];
  }
  const Point3 edge = model.positions[corners[1]] - model.positions[corners[0]];
  const Point3 other = model.positions[corners[2]] - model.positions[corners[0]];
  const Point3 face = normalized(cross(edge, other));
  const double side = dot(face, back) < 0 ? -1 : 1;

  Point3 bulge;
  for (size_t k = 0; k < 3; ++k) {
    const Point3 normal = side * model.normals[corners[k]];
    const double below = dot(position - model.positions[corners[k]], normal);
    bulge = bulge + weights[k] * std::max(0.0, -below) * normal;
  }
  smooth = normalized(side * smooth);
  point.normal = facing(smooth == Point3{} ? side * face : smooth, back);
  point.ray_origin = position + bulge + lift * (side * face);
  return point;
}

}  // namespace relievo

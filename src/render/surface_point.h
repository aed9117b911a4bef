#pragma once

#include "relievo/model.h"
#include "render/ray_scene.h"

namespace relievo {

/// What shading needs to know of a hit.
struct SurfacePoint {
  Point3 normal;      ///< smooth, unit, on the viewer's side
  Point3 ray_origin;  ///< just above the smooth surface: where rays to the light begin
  Point2 uv;
};

/// The point that a ray towards -`back` has hit. Rays from a flat triangle of a rounded surface
/// meet its neighbours near the border of the light; therefore they begin on the curved surface
/// that the vertices' normals suggest (J. Hanika, Hacking the Shadow Terminator, 2021), `lift`
/// above it.
SurfacePoint surface_point(const Model& model, const RayHit& hit, Point3 back, double lift);

}  // namespace relievo

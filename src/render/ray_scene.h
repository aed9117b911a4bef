#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <optional>

#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// The point at which a ray meets a triangle: (1 - u - v) corner 0 + u corner 1 + v corner 2.
struct RayHit {
  int triangle = 0;
  double u = 0;
  double v = 0;
  bool is_ink = false;  ///< whether the triangle is one of the ink
};

/// A model's triangles, ready for rays. Queries may run on several threads.
class RayScene {
 public:
  /// Builds the scene of a model and its ink, which may be left out. Errors: `limit` if there is
  /// not enough memory, `interrupted`. O(F log F).
  static Result<RayScene> build(const Model& model, const InkMesh& ink, const RunContext& context);

  /// Finds the nearest triangle along the ray, whichever side it shows, or ink that faces it.
  std::optional<RayHit> first_hit(Point3 origin, Point3 direction) const;

  /// Returns whether a triangle, not of ink, lies along the ray within `length`.
  bool blocked(Point3 origin, Point3 direction, double length) const;

 private:
  std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device_{nullptr, rtcReleaseDevice};
  std::unique_ptr<RTCSceneTy, void (*)(RTCScene)> scene_{nullptr, rtcReleaseScene};
};

/// A point of the surface to be shaded.
struct SurfacePoint {
  Point3 normal;      ///< smooth, unit, on the viewer's side
  Point3 face;        ///< normal of the flat triangle, unit, on the same side
  Point3 ray_origin;  ///< origin of rays to the light, just above the smooth surface
  Point2 uv;
};

/// Returns the texture coordinates at which a ray has hit a model or its ink.
Point2 texture_place(const Model& model, const RayHit& hit);

/// Returns the point that a ray towards -`back` has hit. Rays from a flat triangle of a rounded
/// surface would meet its neighbours near the border of the light; therefore they begin `lift`
/// above the curved surface that the vertices' normals suggest (J. Hanika, Hacking the Shadow
/// Terminator, 2021).
SurfacePoint surface_point(const Model& model, const RayHit& hit, Point3 back, double lift);

}  // namespace relievo

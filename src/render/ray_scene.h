#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <optional>

#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// Where a ray meets a triangle: (1 - u - v) corner 0 + u corner 1 + v corner 2.
struct RayHit {
  int triangle = 0;
  double u = 0;
  double v = 0;
};

/// A model's triangles, ready for rays. Queries may run on several threads.
class RayScene {
 public:
  /// Errors: `limit` where memory does not suffice, `interrupted`. O(F log F).
  static Result<RayScene> build(const Model& model, const RunContext& context);

  /// The nearest triangle along the ray, whichever side it shows.
  std::optional<RayHit> first_hit(Point3 origin, Point3 direction) const;

  /// Whether anything lies along the ray within `length`.
  bool blocked(Point3 origin, Point3 direction, double length) const;

 private:
  struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  };
  struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };

  std::unique_ptr<RTCDeviceTy, ReleaseDevice> device_;
  std::unique_ptr<RTCSceneTy, ReleaseScene> scene_;
};

/// What shading needs to know of a hit.
struct SurfacePoint {
  Point3 normal;      ///< smooth, unit, on the viewer's side
  Point3 face;        ///< the flat triangle's, unit, on the same side
  Point3 ray_origin;  ///< just above the smooth surface: where rays to the light begin
  Point2 uv;
};

/// The point that a ray towards -`back` has hit. Rays from a flat triangle of a rounded surface
/// meet its neighbours near the border of the light; therefore they begin on the curved surface
/// that the vertices' normals suggest (J. Hanika, Hacking the Shadow Terminator, 2021), `lift`
/// above it.
SurfacePoint surface_point(const Model& model, const RayHit& hit, Point3 back, double lift);

}  // namespace relievo

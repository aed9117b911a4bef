#pragma once

#include "relievo/model.h"
#include "relievo/render.h"

namespace relievo {

/// An orthographic camera. The axes are unit, in model space.
struct Camera {
  Point3 right{1, 0, 0};
  Point3 up{0, 1, 0};
  Point3 back{0, 0, 1};  ///< towards the viewer
  Point3 centre;         ///< the point of model space in the picture's middle
  double unit = 1;       ///< model px per picture px
  double distance = 1;   ///< from the centre to where rays begin, outside of the model
  int width = 1;         ///< of the picture, px
  int height = 1;
};

/// Turned by yaw and pitch, with everything of the model in the picture and a margin around it.
/// Precondition: the model has triangles.
Camera framing_camera(const Model& model, const RenderOptions& options);

/// Where the ray of a point of the picture (px, y down) begins; it runs along -camera.back.
Point3 ray_origin(const Camera& camera, Point2 picture);

/// The same vector given in the camera's axes, in model space.
inline Point3 from_camera(const Camera& camera, Point3 v) {
  return v.x * camera.right + v.y * camera.up + v.z * camera.back;
}

}  // namespace relievo

#pragma once

#include "relievo/model.h"
#include "relievo/point.h"
#include "relievo/render.h"
#include "render/shading.h"

namespace relievo {

/// Turned by yaw and pitch, with everything of the model in the picture and a margin around it.
/// Precondition: the model has triangles.
Camera framing_camera(const Model& model, const RenderOptions& options);

/// Where the ray of a point of the picture (px, y down) begins; it runs along -camera.back.
Point3 ray_origin(const Camera& camera, Point2 picture);

}  // namespace relievo

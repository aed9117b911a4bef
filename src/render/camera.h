#pragma once

#include "relievo/model.h"
#include "relievo/point.h"
#include "relievo/render.h"
#include "render/shading.h"

namespace relievo {

/// Returns a camera turned by yaw and pitch, with the whole model in the picture and a margin
/// around it. Precondition: the model has triangles.
Camera framing_camera(const Model& model, const RenderOptions& options);

/// Returns the origin of the ray of a point of the picture (px, y down); it runs along
/// -camera.back.
Point3 ray_origin(const Camera& camera, Point2 picture);

}  // namespace relievo

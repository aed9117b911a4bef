#pragma once

#include "relievo/point.h"
#include "relievo/render.h"
#include "render/camera.h"
#include "render/rgb.h"

namespace relievo {

/// An orthonormal basis around a unit vector.
struct AxisFrame {
  Point3 first;
  Point3 second;
  Point3 axis;
};

AxisFrame frame_around(Point3 axis);

/// The lights of a picture. Directions are unit, in model space.
struct LightRig {
  AxisFrame key;       ///< its axis points to the middle of the key light
  double key_tangent;  ///< tangent of its angular radius
  Rgb key_light;       ///< what a surface that faces it receives
  Point3 up;
  Rgb sky;     ///< light from above ...
  Rgb ground;  ///< ... and from below
  Point3 rim;  ///< a broad glow behind the model that parts it from the background
  Rgb rim_light;
  double gloss;  ///< strength of the highlight
};

/// A key light with soft fill for clay, and more even, neutral light for a drawing, under which a
/// surface that faces the viewer keeps its colour.
LightRig light_rig(const RenderOptions& options, const Camera& camera);

/// A direction to the key light; `square` is a point of the unit square.
Point3 key_direction(const LightRig& rig, Point2 square);

/// A direction above a surface, distributed with the cosine to its normal, the frame's axis.
Point3 ambient_direction(const AxisFrame& surface, Point2 square);

/// Light that comes from a direction where nothing is in the way.
Rgb surroundings(const LightRig& rig, Point3 direction);

/// The highlight of a surface under the key light.
double highlight(const LightRig& rig, Point3 normal, Point3 to_light, Point3 to_viewer);

/// Keeps what is below 0.7 and bends what is above towards 1, without a corner.
Rgb tone_curve(Rgb colour);

}  // namespace relievo

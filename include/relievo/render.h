#pragma once

#include <optional>

#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/point.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

enum class Shading {
  clay,      ///< plain and slightly warm, to show the shape
  textured,  ///< the drawing under neutral light, to show the colours
};

enum class Background { transparent, white, gradient };

/// A part of the canvas that fills the width of the picture.
struct RenderWindow {
  Point2 centre;     ///< canvas px, y down; the surface above it is in the picture's middle
  double width = 0;  ///< canvas px, > 0
};

struct RenderOptions {
  int width = 1000;  ///< of the picture, px
  int height = 800;  ///< of the picture, px
  double yaw = 0;    ///< degrees by which the camera moves to its right around the model
  double pitch = 0;  ///< degrees by which the camera moves up
  std::optional<RenderWindow> window;  ///< default: the whole model with a margin
  Shading shading = Shading::clay;
  Background background = Background::gradient;
  Point3 light{-0.55, 0.65, 0.6};  ///< towards the key light; x right, y up, z to the camera
  double light_radius = 9;         ///< of the key light as seen from the model, degrees, [0, 60]
  int samples = 6;                 ///< rays to the model per pixel, 1 to 1024
  int ambient_rays = 3;            ///< rays to the surroundings per sample, 0 to 64
  Ink ink = Ink::shell;            ///< of a model that is `unfinished`, if it is textured
};

enum class View { front, three_quarter, side };

/// Returns options with the yaw and pitch of a named view.
inline RenderOptions seen_from(View view, RenderOptions options) {
  options.yaw = view == View::front ? 0 : view == View::side ? 90 : 38;
  options.pitch = view == View::three_quarter ? 14 : 0;
  return options;
}

/// Renders an orthographic picture of the model: RGBA, straight alpha, sRGB. The front view of a
/// window over the whole canvas coincides with the drawing. Faces are seen from both sides; shadows
/// and ambient occlusion are traced, with noise that is the same in every run and for any number of
/// threads. `drawing` may be null unless the shading is textured. Errors: `usage` for options out
/// of range, `bad_input` for a model without triangles or with numbers that are not finite,
/// `limit` above 100 megapixels or 16384 px a side, `interrupted`. O(pixels * samples * rays).
Result<Image8> render_model(const Model& model, const Drawing* drawing,
                            const RenderOptions& options, const RunContext& context = {});

/// Renders the front, three-quarter and side views beside each other at the same scale, each of
/// options.width x options.height px; yaw, pitch and window of the options are ignored. Errors: as
/// render_model.
Result<Image8> render_contact_sheet(const Model& model, const Drawing* drawing,
                                    const RenderOptions& options, const RunContext& context = {});

}  // namespace relievo

#pragma once

#include "kernel/geometry/polygon.h"
#include "relief/joining/joining.h"
#include "relievo/scene.h"

namespace relievo {

/// A layered drawing as it was understood.
struct ConnectedScene {
  Scene scene;
  Joining proposals;  ///< what of the scene was guessed; by part, in its order
};

/// Connects the parts of a layered drawing as connect_parts proposes, unless the drawing itself
/// says how. Where `amounts`, parts get a c that makes them about as deep as they are narrow, and
/// those that look hollow a negative d.
/// Near-linear as connect_parts.
ConnectedScene connect_scene(Scene scene, bool amounts, const PartColors& colors = {});

}  // namespace relievo

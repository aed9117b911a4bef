#pragma once

#include <string>

#include "apps/cli/outputs.h"
#include "relievo/bytes.h"
#include "relievo/scene.h"

namespace relievo::cli {

/// The drawing that a scene file refers to.
struct SceneDrawing {
  std::string file;  ///< its path; empty if it has no file of its own
  Bytes bytes;       ///< empty if there is no drawing
};

/// Returns the file extension for the format of a picture, without the dot.
std::string picture_kind(ByteView bytes);

/// Adds the scene file and, if the drawing is not in its folder or below, a copy of the drawing
/// beside it. The copy is numbered if its name is taken. Errors: as write_scene.
void add_scene(Outputs& outputs, const std::string& output, Scene scene,
               const SceneDrawing& drawing);

}  // namespace relievo::cli

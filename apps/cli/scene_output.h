#pragma once

#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/bytes.h"
#include "relievo/files.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::cli {

/// A drawing to which a scene file refers.
struct SceneDrawing {
  std::string file;  ///< its path; empty where it has none of its own
  Bytes bytes;       ///< empty: there is no drawing
};

/// What kind of picture it is, as the ending of its name.
std::string picture_kind(ByteView bytes);

/// The scene file, and a copy of the drawing beside it where that lies elsewhere, numbered where
/// another file has its name. Errors: as write_scene.
Result<std::vector<OutputFile>> scene_files(const std::string& output, Scene scene,
                                            const SceneDrawing& drawing);

}  // namespace relievo::cli

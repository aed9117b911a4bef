#pragma once

#include <string>

#include "api/inputs.h"
#include "apps/cli/outputs.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Returns whether the file may bring parts of its own: an SVG, OpenRaster or Photoshop drawing, a
/// folder, or a painting in an archive.
bool is_layered(const InputFile& file);

/// Returns whether the parts are layers or shapes of the drawing, and not found in its picture.
bool has_own_parts(const SceneInput& drawing);

/// Makes the files of `segment` for a drawing with parts of its own: the scene, a project or layers
/// by the ending of `output`, and the overlay if it has a name. Errors: those of the encoders.
Result<Outputs> layer_outputs(const std::string& output, const std::string& overlay,
                              const InputFile& file, const SceneInput& drawing);

}  // namespace relievo::cli

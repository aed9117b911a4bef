#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo {

/// A drawing and its parts.
struct DrawnScene {
  Scene scene;
  Drawing drawing;                           ///< empty where there is none
  std::vector<std::filesystem::path> files;  ///< all that were read
  std::vector<std::string> warnings;         ///< what a person should know, one sentence each
  bool proposed = false;                     ///< the parts were guessed, not annotated
};

/// Reads a layered drawing (SVG, OpenRaster, a folder of pictures), a flat picture (as
/// understand_picture), a project, or a scene file with the drawing that it names; told by the
/// content. Errors begin with the file's name: `file`,
/// `bad_input`, `contradiction`, `limit`, `interrupted`.
Result<DrawnScene> read_drawing(const std::filesystem::path& path, const RunContext& context = {});

/// Finds the parts of a flat picture (PNG, JPEG, GIF), completes what of them is hidden, and orders
/// and joins them. Errors: as read_drawing.
Result<DrawnScene> understand_picture(const std::filesystem::path& path,
                                      const RunContext& context = {});

}  // namespace relievo

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
  Drawing drawing;                           ///< empty if there is none
  std::vector<std::filesystem::path> files;  ///< all files read
  std::vector<std::string> warnings;         ///< for the user, one sentence each
  bool proposed = false;                     ///< the parts were guessed, not annotated
};

/// Reads a layered drawing (SVG, OpenRaster, Photoshop, a folder of pictures), a flat picture (as
/// understand_picture), a project, or a scene file with the drawing that it names. The content of
/// the file decides which. Errors, whose `where` begins with the file's name: `file`, `bad_input`,
/// `contradiction`, `limit`, `interrupted`.
Result<DrawnScene> read_drawing(const std::filesystem::path& path, const RunContext& context = {});

/// Finds the parts of a flat picture (PNG, JPEG, GIF, WebP, AVIF, HEIC), completes hidden areas,
/// and orders and joins the parts. Errors: as read_drawing.
Result<DrawnScene> understand_picture(const std::filesystem::path& path,
                                      const RunContext& context = {});

}  // namespace relievo

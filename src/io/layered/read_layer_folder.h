#pragma once

#include <filesystem>
#include <vector>

#include "io/image/image_limits.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Reads a folder of pictures with transparency, one a layer: those that its layers.tsv lists
/// (see layer_files.h), else all its PNG files in the natural order of their names, back to
/// front. The canvas is as large as the layers need. One layer is in memory at a time. Adds the
/// files that it read to `files`. Errors name the file: `file`, `bad_input` (damaged, or a layer
/// that a link puts outside the folder), `limit`.
Result<understanding::LayeredDrawing> read_layer_folder(const std::filesystem::path& folder,
                                                        std::vector<std::filesystem::path>& files,
                                                        const ImageLimits& limits = {});

}  // namespace relievo

#pragma once

#include <filesystem>
#include <vector>

#include "io/image/image_limits.h"
#include "io/layered/layer_pile.h"

namespace relievo {

/// A drawing from a folder, and what was read for it.
struct FolderDrawing {
  LayeredDrawing content;
  std::vector<std::filesystem::path> files;
};

/// Reads a folder of pictures with transparency, one a layer: those that its layers.tsv lists
/// (see layer_table.h), else all its PNG files in the natural order of their names, back to
/// front. The canvas is as large as the layers need. One layer is in memory at a time. Errors
/// name the file: file, bad_input (damaged, a layer that a link puts outside of the folder,
/// nothing opaque), limit.
Result<FolderDrawing> read_layer_folder(const std::filesystem::path& folder,
                                        const ImageLimits& limits = {});

}  // namespace relievo

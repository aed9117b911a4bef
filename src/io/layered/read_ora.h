#pragma once

#include <string>
#include <vector>

#include "io/archive/archive.h"
#include "io/image/image_limits.h"
#include "io/layered/layer_pile.h"

namespace relievo {

/// Whether the archive says that it is an OpenRaster file.
bool is_ora(const std::vector<ArchiveEntry>& entries);

struct OraDrawing {
  LayeredDrawing content;
  std::vector<std::string> warnings;
};

/// Reads an OpenRaster drawing: its layers become parts as those of a folder do. Hidden layers
/// are left out; blending other than source-over is painted as such, with a warning. A layer or
/// a group of layers whose name begins with "texture:" is painted but no part, and where a name
/// begins with "part:", the others are texture. Errors name the entry: bad_input, limit.
Result<OraDrawing> read_ora(const std::vector<ArchiveEntry>& entries,
                            const ImageLimits& limits = {});

}  // namespace relievo

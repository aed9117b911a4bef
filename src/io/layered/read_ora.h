#pragma once

#include <vector>

#include "io/archive/archive.h"
#include "io/image/image_limits.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Returns whether the archive states that it is an OpenRaster file.
bool is_ora(const std::vector<ArchiveEntry>& entries);

/// Reads an OpenRaster drawing. Hidden layers are left out. Every blending mode is painted as
/// source-over; others give a warning. A layer or group whose name begins with "texture:" is
/// painted but becomes no part; where some name begins with "part:", all layers without a role are
/// texture. Errors name the entry: `bad_input`, `limit`.
Result<understanding::LayeredDrawing> read_ora(const std::vector<ArchiveEntry>& entries,
                                               const ImageLimits& limits = {});

}  // namespace relievo

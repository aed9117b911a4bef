#pragma once

#include "kernel/base/result.h"
#include "relief/drawing/basins.h"
#include "relief/drawing/drawing.h"

namespace relievo {

/// Divides a drawing into basins by the watershed of the distance to its lines, and proposes which
/// of them make one part. Errors: `bad_input` where the drawing is empty or holds no line.
/// Near-linear in pixels.
Result<Basins> find_basins(const Drawing& drawing);

}  // namespace relievo

#pragma once

#include "relief/drawing/basins.h"

namespace relievo {

/// Fills `basins` and `borders` from index, ink and barrier. `rgb` is the drawing on white.
/// O(pixels + border pixels log border pixels).
void measure_basins(const Image8& rgb, Basins& basins);

}  // namespace relievo

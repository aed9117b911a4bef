#pragma once

#include <vector>

#include "relievo/image.h"
#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Fills `basins` and `borders` from index, ink, barrier and figure. `rgba` is the drawing, `rgb`
/// the same on white. O(pixels + border pixels log border pixels).
void measure_basins(const Image8& rgba, const Image8& rgb, Basins& basins);

/// Fills `borders` from index, ink and barrier. O(border pixels log border pixels).
void measure_borders(const Image8& rgb, Basins& basins);

/// The borders between basins inside a window of pixels, its end excluded; sorted by a, b. Without
/// steps of colour.
std::vector<BasinBorder> borders_within(const Basins& basins, int x0, int y0, int x1, int y1);

}  // namespace relievo::understanding

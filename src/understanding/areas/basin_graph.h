#pragma once

#include <vector>

#include "relievo/image.h"
#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Computes `basins.basins`, but for their inradii, and `basins.borders` from index, ink, barrier
/// and the maps of what is perceived. `rgba` is the drawing, `rgb` the same on white. O(pixels +
/// border pixels log border pixels).
void measure_basins(const Image8& rgba, const Image8& rgb, Basins& basins);

/// Computes `basins.borders` from index, ink and barrier. O(border pixels log border pixels).
void measure_borders(const Image8& rgb, Basins& basins);

/// Measures the borders between basins inside the window from (x0, y0) to before (x1, y1), sorted
/// by a, b. Without the drawing on white their steps of colour are 0.
std::vector<BasinBorder> borders_within(const Basins& basins, int x0, int y0, int x1, int y1,
                                        const Image8* rgb = nullptr);

}  // namespace relievo::understanding

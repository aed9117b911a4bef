#pragma once

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"

namespace relievo {

/// The lines along which a field of one channel reaches `level` (marching squares). Pixel (x, y)
/// is the sample at (x + 1/2, y + 1/2); between samples the field is bilinear along the grid
/// lines, and around the image it is `outside`, below the level. What lies at or above the level
/// is on the inner side: rings around it have positive area, holes in it negative. Where two
/// diagonal samples of a cell are above and two below, the mean of the four decides. Rings come
/// in the order of their first crossing, row by row; they never meet. O(pixels).
Outline level_contours(const ImageF& field, float level, float outside = 0);

}  // namespace relievo

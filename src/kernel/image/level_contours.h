#pragma once

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"

namespace relievo {

/// Traces the lines along which a field of one channel reaches `level` (marching squares). Pixel
/// (x, y) is the sample at (x + 1/2, y + 1/2). The field is linear along the lines between samples,
/// and `outside`, which is below the level, around the image. Rings around values at or above the
/// level have positive area, holes negative. Where two diagonal samples of a cell are above and two
/// below, the mean of the four decides. Rings never meet; they come in the order of their first
/// crossing, row by row. O(pixels).
Outline level_contours(const ImageF& field, float level, float outside = 0);

}  // namespace relievo

#pragma once

#include <cstdint>

#include "relievo/image.h"

namespace relievo {

/// Grows the seeds of `label` (values > 0) over all pixels of value 0 that they can reach by
/// steps over shared sides, lowest `height` first and, at one height, nearest to the seeds first:
/// fronts meet on the ridges. Pixels with negative labels are walls. Both images have one channel
/// and the same size. Priority flood with 256 queues (Meyer 1994). O(pixels).
void flood_from_seeds(const Image8& height, Image<int32_t>& label);

}  // namespace relievo

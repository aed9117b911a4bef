#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/psd/psd_file.h"
#include "kernel/geometry/region.h"
#include "relievo/bytes.h"

namespace relievo {

/// Returns the colour of a solid fill in RGB; nothing for another fill or colour space.
std::optional<std::array<uint8_t, 3>> fill_color(ByteView solid_fill);

/// Reads a vector mask on a canvas of this size: the area that it shows. Nothing where it is
/// disabled or damaged. Curves are flattened to a tenth of a pixel or better.
std::optional<Region> vector_mask(ByteView block, int width, int height);

/// Returns how much of each pixel of the box the region covers, 0 to 255, row by row. O(area of the
/// box + crossings).
std::vector<uint8_t> coverage(const Region& region, const PixelBox& box);

}  // namespace relievo

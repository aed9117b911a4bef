#pragma once

#include <optional>

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"

namespace relievo::understanding {

/// The regions of a drawing, at a size at which necks are looked for.
struct NeckGrid {
  double cell = 1;        ///< px
  Image<int32_t> region;  ///< 0 background
  Image8 wall;            ///< 1 where a line passes

  bool has(int x, int y) const { return x >= 0 && y >= 0 && x < region.width && y < region.height; }
};

/// Where a limb grows out of the rest of a region, in cells. The neck is the chord from the first
/// point of the limb's contour to the last; the limb lies to its left.
struct Neck {
  Ring limb;
  Ring whole;          ///< the contour of both
  bool round = false;  ///< the limb, as a head is
};

/// The neck that is narrowest beside the size of its limb, of `least_area` cells at least. It is a
/// chord inside the region, from a concave place of the region's own contour to the nearest other
/// one, rather a concave one as well. The limb is longer than the neck, or holds a disc as wide,
/// and borders on the background for the most part; the rest does so in part, and holds a larger
/// disc beside the neck. Lines that end inside the region are contour. O(grid + contour^2 log
/// contour).
std::optional<Neck> find_neck(const NeckGrid& grid, int region, double least_area);

}  // namespace relievo::understanding

#pragma once

#include <optional>

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"

namespace relievo::understanding {

/// The regions of a drawing at the resolution at which necks are searched.
struct NeckGrid {
  double cell = 1;        ///< px
  Image<int32_t> region;  ///< [cells] 0 background
  Image8 wall;            ///< [cells] 1 where a line or bridge passes

  bool has(int x, int y) const { return x >= 0 && y >= 0 && x < region.width && y < region.height; }
};

/// A neck: the chord between a region and a limb that grows out of it. It runs from the first to
/// the last point of `limb`, with the limb to its left. Coordinates are in cells.
struct Neck {
  Ring limb;           ///< contour of the limb
  Ring whole;          ///< contour of the region, limb included
  bool round = false;  ///< whether the limb is round, like a head
};

/// Finds the neck that is narrowest compared with its limb, whose area is at least `least_area`
/// cells. A neck is a chord inside the region from a concave point of its contour to the nearest
/// other point, preferably a concave one. The limb is longer than the neck or contains a disc
/// nearly as wide, and most of its contour borders on the background. The rest of the region
/// borders on the background in part, and contains a large disc beside the neck. Lines that end
/// inside the region are part of its contour. O(grid + contour^2 log contour).
std::optional<Neck> find_neck(const NeckGrid& grid, int region, double least_area);

}  // namespace relievo::understanding

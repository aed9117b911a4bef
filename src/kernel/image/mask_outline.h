#pragma once

#include "kernel/geometry/polygon.h"
#include "kernel/image/mask.h"

namespace relievo {

struct OutlineOptions {
  int min_sides = 12;       ///< rings with fewer pixel sides are dropped
  int smoothing = 4;        ///< passes of a (1, 2, 1) / 4 average, against the staircase
  double tolerance = 0.05;  ///< points that are so close to the line between others go, px
};

/// Sub-pixel outline of a mask in canvas px: the middles of its pixel sides, smoothed. Outer rings
/// have positive area, holes negative. The largest ring is kept whatever its size.
/// O(box + boundary * log boundary).
Outline outline_of(const Mask& mask, const OutlineOptions& options = {});

}  // namespace relievo

#pragma once

#include <cstdint>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/mask.h"
#include "relievo/scene.h"

namespace relievo {

/// The parts of a scene as sets of pixels of a coarse grid.
struct LayerGrid {
  double scale = 1;  ///< grid pixels per canvas px
  std::vector<Mask> masks;
  std::vector<int64_t> areas;  ///< in grid pixels

  bool has(int part, Point2 p) const;
};

/// `side`: pixels along the longest side of the canvas. O(points + boxes).
LayerGrid make_layer_grid(const Scene& scene, int side);

/// Number of pixels that two parts have in common. O(the smaller box).
int64_t common_area(const LayerGrid& grid, int a, int b);

/// How far each pixel of the box of a part's mask is, inside the part, from where it lies beside
/// another, in grid pixels; infinite where that cannot be reached. O(n log n) in its pixels.
std::vector<double> distance_from_free_end(const LayerGrid& grid, int part, int other);

}  // namespace relievo

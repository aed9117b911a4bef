#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "kernel/image/mask.h"
#include "relievo/scene.h"
#include "understanding/joins/roots.h"

namespace relievo::understanding {

/// `side`: pixels along the longest side of the canvas. O(points + boxes).
LayerGrid make_layer_grid(const Scene& scene, int side);

/// Number of pixels that two parts have in common. O(the smaller box).
int64_t common_area(const LayerGrid& grid, int a, int b);

/// How far from what it has in common with `root` a part meets another, as a share of its reach
/// from there; 1 where the part has that root in its middle, as the brim of a hat. O(the part's
/// box).
double share_from_root(const LayerGrid& grid, int part, int root, int other);

/// The radius of the largest disc inside a part that touches another, in grid pixels; that part
/// itself for any. O(the part's box).
double thickness_at(const LayerGrid& grid, int part, int other);

/// Two parts that overlap.
struct Overlap {
  int upper = -1;
  int lower = -1;
  double upper_beside = 0;  ///< share of the upper part that is not over the lower one
  double lower_beside = 0;
};

/// All pairs of parts that have more than a few pixels in common, by the upper one. O(parts^2
/// boxes).
std::vector<Overlap> find_overlaps(const LayerGrid& grid);

/// How far each pixel of the box of a mask is, inside it, from the pixels that `is_source` tells
/// of, in pixels; infinite where that cannot be reached. O(n log n) in its pixels.
std::vector<double> distance_inside(const Mask& mask,
                                    const std::function<bool(int, int)>& is_source);

}  // namespace relievo::understanding

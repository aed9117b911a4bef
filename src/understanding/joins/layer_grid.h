#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "kernel/image/mask.h"
#include "relievo/scene.h"

namespace relievo::understanding {

/// A part that has at least this share of its area outside another part does not lie on that.
constexpr double least_protrusion = 0.3;

/// A part that has at most this share of its area outside another part lies within that.
constexpr double most_outside = 0.03;

/// The parts of a scene as sets of pixels of a coarse grid.
struct LayerGrid {
  double scale = 1;  ///< grid pixels per canvas px
  std::vector<Mask> masks;
  std::vector<int64_t> areas;  ///< in grid pixels

  /// Whether a part has a point of the canvas, px.
  bool has(int part, Point2 p) const;
};

/// Rasterises the parts of a scene; `side` is the number of grid pixels along the longest side of
/// the canvas. O(points + boxes).
LayerGrid make_layer_grid(const Scene& scene, int side);

/// The index of a canvas pixel in the box of a mask, row by row.
inline int mask_index(const Mask& mask, int x, int y) {
  return (y - mask.top) * mask.inside.width + x - mask.left;
}

/// Counts the pixels that two parts have in common. O(the smaller box).
int64_t common_area(const LayerGrid& grid, int a, int b);

/// The distance between the middles of what a part has in common with `root` and with `other`, as a
/// share of the part's reach from the first; 1 where that middle is also the middle of the part, as
/// for the brim of a hat. O(the part's box).
double share_from_root(const LayerGrid& grid, int part, int root, int other);

/// The radius, in grid pixels, of the largest disc inside a part that touches another; where
/// `other` is the part itself, of the largest disc inside it. O(the part's box).
double thickness_at(const LayerGrid& grid, int part, int other);

/// Two parts that overlap.
struct Overlap {
  int upper = -1;
  int lower = -1;
  double upper_beside = 0;  ///< share of the upper part that is not over the lower one
  double lower_beside = 0;
};

/// Finds all pairs of parts that have at least 12 pixels in common, ordered by the upper one.
/// O(parts^2 boxes).
std::vector<Overlap> find_overlaps(const LayerGrid& grid);

/// The length of the shortest way inside a mask from each pixel of its box to one for which
/// `is_source` holds, in pixels; infinite where there is none. O(n log n) in its pixels.
std::vector<double> distance_inside(const Mask& mask,
                                    const std::function<bool(int, int)>& is_source);

}  // namespace relievo::understanding

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/mask.h"
#include "relief/completion/part_regions.h"
#include "relief/join_proposals/join_proposals.h"
#include "relief/stacking/stacking.h"
#include "relievo/scene.h"

namespace relievo {

/// A run of a part's outer ring that borders on parts behind it.
struct Root {
  const LabelRing* ring = nullptr;
  size_t first = 0;  ///< side
  size_t count = 0;
  int lower = -1;             ///< the part behind that it borders on most
  bool opens_before = false;  ///< the background begins at its first end, so that it leaves there
  bool opens_after = false;
};

/// What a part borders on.
struct Surroundings {
  std::vector<Root> roots;
  std::vector<int> lower;  ///< parts behind it that it touches, sorted
  bool enclosed = false;   ///< it does not touch the background
};

/// O(sides of the part).
Surroundings surroundings(const PartRegions& regions, const Stacking& stacking, int part);

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

/// A run of one ring of a part inside another part.
struct RingRun {
  const Ring* ring = nullptr;
  RingMeasure measure;
  double from = 0;
  double length = 0;  ///< the whole ring's where it does not leave

  Point2 at(double s) const { return point_at(*ring, measure, from + s); }
};

/// What lies beside another part with less than this share of its area lies mostly on it.
constexpr double least_protrusion = 0.3;
/// What lies within another part has at most this share of its area beside that.
constexpr double most_outside = 0.03;
/// Steps along outlines that look for what lies inside other parts, in grid pixels.
constexpr double root_step = 1.5;

/// All runs of the outer rings of a part inside another, the longest first; single steps outside do
/// not part them. The outline outlives them. O(its length / root_step).
std::vector<RingRun> runs_inside(const LayerGrid& grid, const Outline& outline, int other);

/// The cap of a limb's root, as arc lengths of the run.
struct RootCap {
  double from = 0;
  double to = 0;
};

/// Where on the run of a part's outline inside another its join lies best: around its tip, from
/// anchor to anchor of those who drew it (canvas px) where there are some near the ends.
RootCap find_root_cap(const LayerGrid& grid, const RingRun& run, int part, int other,
                      const std::vector<Point2>& anchors);

/// Where in its pixels a mask has a point of its box.
inline int mask_index(const Mask& mask, int x, int y) {
  return (y - mask.top) * mask.inside.width + x - mask.left;
}

/// How far each pixel of the box of a mask is, inside it, from the pixels that `is_source` tells
/// of, in pixels; infinite where that cannot be reached. O(n log n) in its pixels.
std::vector<double> distance_inside(const Mask& mask,
                                    const std::function<bool(int, int)>& is_source);

/// The parts that look hollow by their colours: open mouths, wholly inside a larger part, wide, red
/// and much darker than that; and the cups of ears, pink and not dark, which fill a good share of a
/// limb. `limb` tells of each part whether it is one. Ascending; none where no colours are known.
std::vector<int> hollow_parts(const LayerGrid& grid, const PartColors& colors,
                              const std::vector<uint8_t>& limb);

}  // namespace relievo

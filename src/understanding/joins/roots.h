#pragma once

#include <cstdint>
#include <vector>

#include "kernel/image/mask.h"
#include "understanding/completion/part_regions.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

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

/// What lies beside another part with less than this share of its area lies mostly on it.
constexpr double least_protrusion = 0.3;

/// What lies within another part has at most this share of its area beside that.
constexpr double most_outside = 0.03;

/// Steps along outlines that look for what lies inside other parts, in grid pixels.
constexpr double root_step = 1.5;

/// Where in its pixels a mask has a point of its box.
inline int mask_index(const Mask& mask, int x, int y) {
  return (y - mask.top) * mask.inside.width + x - mask.left;
}

}  // namespace relievo::understanding

#pragma once

#include <vector>

#include "relief/completion/part_regions.h"
#include "relief/stacking/stacking.h"

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

}  // namespace relievo

#pragma once

#include <vector>

#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

/// A run of a part's outer ring that borders on parts behind it.
struct Root {
  const LabelRing* ring = nullptr;
  size_t first = 0;  ///< index of its first side
  size_t count = 0;  ///< number of sides
  int lower = -1;    ///< the part behind that it borders on most
  bool opens_before =
      false;  ///< the background begins at its first end, so that the part leaves there
  bool opens_after = false;  ///< likewise at its last end
};

/// The neighbours of a part.
struct Surroundings {
  std::vector<Root> roots;
  std::vector<int> lower;  ///< parts behind it that it touches, in the order of their labels
  bool enclosed = false;   ///< the part does not touch the background
};

/// Finds the neighbours of a part among regions that are sorted back to front. O(sides of the
/// part).
Surroundings surroundings(const PartRegions& regions, int part);

}  // namespace relievo::understanding

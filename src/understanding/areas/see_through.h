#pragma once

#include <cstdint>
#include <vector>

#include "relievo/image.h"

namespace relievo::understanding {

/// An area that two parts share, since the outline of each is drawn through the other.
struct SharedArea {
  uint16_t shared = 0;  ///< its label
  uint16_t a = 0;       ///< label of the rest of one part
  uint16_t b = 0;       ///< label of the rest of the other part
};

/// Finds the areas between two others whose outlines cross at both ends of the area. At such an
/// X-junction both outlines run straight on. `labels`: 0 is background; areas meet in the middle of
/// lines, which are `line_width` px wide. O(pixels).
std::vector<SharedArea> find_shared_areas(const Image16& labels, double line_width);

}  // namespace relievo::understanding

#pragma once

#include <cstdint>
#include <vector>

#include "relievo/image.h"

namespace relievo::understanding {

/// An area that two parts share, since the outline of either is drawn through the other.
struct SharedArea {
  uint16_t shared = 0;  ///< labels
  uint16_t a = 0;
  uint16_t b = 0;
};

/// Areas between two others whose outlines cross there, twice: at both ends of what the area has in
/// common with either, their outlines go straight on through each other, as at an X. `labels` are
/// those of areas, 0 is background; they meet in the middle of lines `line_width` px wide.
/// O(pixels).
std::vector<SharedArea> find_shared_areas(const Image16& labels, double line_width);

}  // namespace relievo::understanding

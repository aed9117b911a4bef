#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "relievo/image.h"

namespace relievo::understanding {

/// Finds pairs of areas that are likelier two pieces of one part than two parts, the likeliest
/// first. A third area hides both, as T-junctions show, and the contour of one continues behind it
/// in the contour of the other. The likelihood depends on the bend and length of the hidden
/// contour, the sizes of the areas and whether they stand side by side. `labels`: 0 is background.
/// O(pixels + contour ends at an area, squared).
std::vector<std::pair<uint16_t, uint16_t>> find_pieces(const Image16& labels);

/// A contour of an area that continues, behind what separates them, in a contour of the background.
struct HoleCue {
  uint16_t area = 0;    ///< label of the area, not 0
  uint16_t before = 0;  ///< label that has this contour on one side of what separates them
  uint16_t after = 0;   ///< label that has it on the other side
};

/// Finds areas through which the background may be seen, such as between the legs of an animal, by
/// their contours alone: one continues nearly straight in a contour of the background. The area
/// hardly touches the background and not the picture's border. `labels`: 0 is background.
/// Precondition: no label is 65535. O(pixels + contour ends at an area, squared).
std::vector<HoleCue> find_holes(const Image16& labels);

}  // namespace relievo::understanding

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "relievo/image.h"

namespace relievo::understanding {

/// Pairs of areas that are likelier pieces of one part than two parts, the likeliest first: where a
/// third one hides both, as junctions tell, and the contour of one goes on in that of the other
/// behind it, by how it bends, how far that is, their sizes and whether they stand side by side.
/// `labels` are those of areas, 0 is background. O(pixels + contour ends at an area, squared).
std::vector<std::pair<uint16_t, uint16_t>> find_pieces(const Image16& labels);

/// A contour of an area that goes on, beyond what parts them, in one of the background.
struct HoleCue {
  uint16_t area = 0;    ///< labels, not 0
  uint16_t before = 0;  ///< what has that contour, to one side of what parts them
  uint16_t after = 0;   ///< and to the other
};

/// What tells by contours alone that the background shows in an area, as between the legs of an
/// animal: it hardly touches the background and not the picture's edge, and a contour goes on
/// nearly straight from one into the other. `labels` are those of areas, 0 is background.
/// Precondition: none is 65535. O(pixels + contour ends at an area, squared).
std::vector<HoleCue> find_holes(const Image16& labels);

}  // namespace relievo::understanding

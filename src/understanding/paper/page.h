#pragma once

#include <array>
#include <cstdint>

#include "relievo/image.h"

namespace relievo::understanding {

/// What a mask and the quadrilateral between its corners have in common, of both together: about 1
/// of a page, however it is turned and seen aslant; 0 of nothing. O(pixels).
double page_overlap(const Image8& mask);

/// Whether an area runs along the edges of a picture as a table around a page does: along two of
/// them, or as a strip along one. `at_edge` are its pixels at the left, right, top and bottom.
bool is_surroundings(const std::array<int64_t, 4>& at_edge, int64_t area, int width, int height);

}  // namespace relievo::understanding

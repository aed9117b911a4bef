#pragma once

#include <array>
#include <cstdint>

#include "relievo/image.h"

namespace relievo::understanding {

/// Computes how well a mask fills the quadrilateral between its corners: the area of their
/// intersection over that of their union. It is about 1 for a page, however it is turned and seen
/// in perspective, and 0 for an empty mask. O(pixels).
double page_overlap(const Image8& mask);

/// Returns whether an area lies around a page, as a table does: it runs along two edges of the
/// picture, or as a strip along one. `at_edge` counts its pixels at the left, right, top and bottom
/// edge; `area` is in px.
bool is_around_page(const std::array<int64_t, 4>& at_edge, int64_t area, int width, int height);

}  // namespace relievo::understanding

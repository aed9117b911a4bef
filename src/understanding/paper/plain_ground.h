#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// A drawing (4 channels) without the ground of one colour around it.
struct WithoutGround {
  Image8 rgba;          ///< empty where there is no such ground, or it is white
  bool is_cut = false;  ///< a figure, transparent where the ground is; else a page on a table
};

/// Cuts a painted figure out of an opaque drawing, with the blend at its rim gone, or continues a
/// page over the table that it lies on, in its own light. The ground may have grain and lie in
/// slowly changing light where a good part of the figure is lighter than it in some channel; then
/// small pieces are left out. O(pixels).
WithoutGround without_ground(const Image8& rgba);

}  // namespace relievo::understanding

#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// A drawing without the plain background around it.
struct WithoutBackground {
  Image8 rgba;          ///< 4 channels; empty where there is no such background, or it is white
  bool is_cut = false;  ///< a figure, transparent outside; else a page continued over its table
};

/// Removes a background of one colour from an opaque drawing (4 channels). A painted figure is cut
/// out, without the blend at its rim; a page is continued, in its own light, over the table that it
/// lies on. Where a good part of the figure is lighter than the background in some channel, the
/// background may also have grain and slowly changing light, and small pieces of the figure are
/// dropped. O(pixels).
WithoutBackground without_background(const Image8& rgba);

}  // namespace relievo::understanding

#pragma once

#include "relievo/image.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo::understanding {

/// The disagreement between a drawing's painting and the marks that were read of it.
struct PaintGap {
  double bare = 0;   ///< largest share of a mark, or declared part, where nothing is painted
  double loose = 0;  ///< share of the opaque paint that is in no mark
};

/// Compares a vector drawing, as its reader returned it, with a painting of its whole canvas on
/// transparent ground. Marks below a thousandth of the canvas, and those that blend or blur, may
/// show no paint. Precondition: the painting has four channels. Cost: O(pixels * marks) at worst.
PaintGap find_paint_gap(const LayeredDrawing& drawing, const Image8& painting);

}  // namespace relievo::understanding

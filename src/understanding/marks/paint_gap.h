#pragma once

#include "relievo/image.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo::understanding {

/// The disagreement between a drawing's painting and the marks that were read of it.
struct PaintGap {
  double bare = 0;  ///< largest share of a mark, or declared part, where nothing is painted
  /// Opaque paint that is in no mark or part and not left out / all of this paint and these marks.
  double loose = 0;
};

/// Compares a vector drawing, as its reader or make_parts returned it, with a painting of its whole
/// canvas on transparent ground. Paint at most a pixel beside a mark counts as in it. Marks below a
/// thousandth of the canvas, and those that blend or blur, may show no paint. Precondition: the
/// painting has four channels. Cost: O(pixels * marks) at worst.
PaintGap find_paint_gap(const LayeredDrawing& drawing, const Image8& painting);

/// Longest side of the paintings that are compared, px.
constexpr double compared_side = 400;

/// Largest share of the paint that marks may miss. Drawings that are read well stay below half.
constexpr double most_loose = 0.1;

/// Returns whether the marks that were read of a drawing are not what is painted. Precondition and
/// cost: as for find_paint_gap.
bool departs_from_paint(const LayeredDrawing& drawing, const Image8& painting);

}  // namespace relievo::understanding

#pragma once

#include <vector>

#include "relievo/image.h"
#include "relievo/point.h"

namespace relievo::understanding {

/// A loose end of a stroke.
struct StrokeEnd {
  Point2 at;          ///< px
  Point2 inwards;     ///< unit vector from the end along the stroke
  double length = 0;  ///< px along the stroke to its other end or the first other line
  /// Side of the stroke that it hides, since the first other line ends there (a T-junction): 1 to
  /// the right of `inwards`, -1 to the left, 0 where no line ends at the stroke.
  int hidden_side = 0;
};

/// Finds the loose ends of thinned lines (0 off the lines), in raster order. Strokes are followed
/// for up to `longest` px. O(pixels + ends * longest).
std::vector<StrokeEnd> find_stroke_ends(const Image8& thinned, double line_width, double longest);

}  // namespace relievo::understanding

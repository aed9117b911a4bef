#pragma once

#include <vector>

#include "relievo/image.h"
#include "relievo/point.h"

namespace relievo::understanding {

/// A loose end of a stroke. Where the stroke, followed from there, first passes the end of another
/// line, the side on which that line ends lies behind it.
struct StrokeEnd {
  Point2 at;          ///< px
  Point2 inwards;     ///< unit vector from the end along the stroke
  double length = 0;  ///< px along the stroke to its other end or the first other line
  int behind = 0;     ///< the side that lies behind: 1 on the right of `inwards`, -1 on the left
};

/// Finds them in thinned lines (0 off the lines), in raster order. Strokes are followed for up to
/// `longest` px. O(pixels + ends * longest).
std::vector<StrokeEnd> find_stroke_ends(const Image8& thinned, double line_width, double longest);

}  // namespace relievo::understanding

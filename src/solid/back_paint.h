#pragma once

#include <vector>

#include "relief/surface/visible_sheet.h"
#include "relievo/image.h"
#include "relievo/solid.h"

namespace relievo {

/// A drawing with what backs need below it: a picture of their own, and plain colours.
struct BackPaint {
  Drawing drawing;              ///< empty if there is none
  double shrink = 1;            ///< factor by which the larger picture shrinks v of the drawing
  double behind = 0;            ///< by which v of a figure's back is greater than v in front
  double pictured = 1;          ///< v at which plain colours begin
  Point2 plate{};               ///< texture coordinates of a flat back
  std::vector<Point2> parts{};  ///< of a floor, by part and then of the base; empty: those of the
                                ///< surface in front, moved by `behind`
};

/// Adds to a drawing, which may be empty, what a back needs (BackSide). The sheet lies on the
/// drawing; the mean colour of a part is that over its triangles, or of pixel art that of most of
/// them. Linear.
BackPaint paint_back(const Drawing& drawing, const relief::VisibleSheet& sheet, BackSide side);

}  // namespace relievo

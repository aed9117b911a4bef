#pragma once

#include <vector>

#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/solid.h"

namespace relievo {

/// A drawing with plain colours for backs below it.
struct BackPaint {
  Drawing drawing;              ///< empty if there is none
  double shrink = 1;            ///< factor by which the larger picture shrinks v of the drawing
  Point2 plate{};               ///< texture coordinates of a flat back
  std::vector<Point2> parts{};  ///< of a floor, by part and then of the base; empty: those of the
                                ///< surface in front
};

/// Adds the colours that a back needs to a drawing, which may be empty. `model` lies on it; the
/// colour of a part is the mean over its triangles, or of pixel art that of most of them. Linear.
BackPaint paint_back(const Drawing& drawing, const Model& model, BackSide side);

}  // namespace relievo

#pragma once

#include <vector>

#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/solid.h"

namespace relievo {

/// Where backs lie on the drawing.
struct BackPaint {
  Point2 plate;  ///< a flat one
  std::vector<Point2>
      parts;  ///< a floor's, by part and of a base; empty: as what is in front of it
};

/// A drawing with plain colours below it.
struct PaintedDrawing {
  Drawing drawing;
  double shrink = 1;  ///< of v, so that a model's coordinates go on meaning what they did
  BackPaint paint;
};

/// Adds what a back needs to a drawing, which may be empty. `model` lies on it; the colour of a
/// part is the mean over its triangles. Linear.
PaintedDrawing paint_back(const Drawing& drawing, const Model& model, BackSide side);

}  // namespace relievo

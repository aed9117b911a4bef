#pragma once

#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/solid.h"
#include "solid/solid_steps.h"

namespace relievo {

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

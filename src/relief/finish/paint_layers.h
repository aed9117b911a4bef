#pragma once

#include <string>
#include <vector>

#include "relievo/image.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A picture of one part on its own.
struct PaintedLayer {
  std::string name;
  int left = 0, top = 0;  ///< px of the drawing
  Image8 rgba;            ///< straight alpha; transparent outside the part
};

/// Returns the parts of a drawing as layers, back to front. A part has the drawing's pixels where
/// it is seen; behind others its own colours are extended, except those near outlines, which may be
/// ink. Pixel art keeps its colours. Together the layers give the drawing, which covers the canvas.
/// O(pixels of all parts).
std::vector<PaintedLayer> paint_layers(const Scene& scene, const Drawing& drawing);

}  // namespace relievo::relief

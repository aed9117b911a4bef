#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/image/image_limits.h"
#include "io/layered/raster_layer.h"
#include "kernel/image/image_size.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// A group of layers.
struct LayerGroup {
  std::string name;  ///< may be empty
  int parent = -1;   ///< the group around it, -1: none
  double opacity = 1;
  Blending blending;
  bool passes = false;  ///< its layers blend with what lies below the group, not just in it
  bool merged = false;  ///< it becomes a part as one layer
  bool unnamed =
      false;  ///< it holds a layer and what is clipped to it, and is none of the drawing's
  LayerRole role = LayerRole::proposed;
};

/// The visible layers of a drawing, from back to front, without their pixels. The layers of a group
/// follow each other.
struct LayerStack {
  std::vector<LayerGroup> groups;
  std::vector<RasterLayer> layers;
};

/// Returns the pixels of a layer by its place in the stack.
using PixelsOf = std::function<Result<Image8>(size_t)>;

/// Paints the picture of the layers on a transparent canvas, and makes parts and marks of their
/// opaque areas. Groups are composed on their own unless they pass through. What blends is texture,
/// but for ink, unless it is named as a part; what erases also cuts the parts. Where some layer or
/// group is a part, those without a role are texture. A single layer makes a `flat` drawing. One
/// layer and the open groups are in memory at a time. Errors: those of `pixels_of`; `limit` where
/// groups take too much memory or time.
Result<understanding::LayeredDrawing> compose_layers(ImageSize canvas, LayerStack stack,
                                                     const PixelsOf& pixels_of,
                                                     const ImageLimits& limits);

}  // namespace relievo

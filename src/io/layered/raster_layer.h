#pragma once

#include <optional>
#include <string>

#include "kernel/geometry/region.h"
#include "kernel/image/blend.h"
#include "relievo/image.h"
#include "relievo/point.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// The use of a layer.
enum class LayerRole {
  proposed,  ///< not stated: parts are proposed from all layers of the drawing together
  part,      ///< one part, as large as the layer's opaque area
  texture,   ///< painted, but no part
};

/// One layer of a painted drawing, or one sprite, or a group of layers that is like one.
struct RasterLayer {
  std::string name;    ///< may be empty
  int group = -1;      ///< innermost group of layers, -1: none
  int x = 0;           ///< of its left column on the canvas, px
  int y = 0;           ///< of its top row
  double opacity = 1;  ///< in [0, 1], of the layer as a whole
  Blending blending;
  LayerRole role = LayerRole::proposed;
  std::optional<double> c;  ///< of its part
  std::optional<double> d;
  std::optional<double> flat;
  std::optional<Point2> lean;
  Image8 rgba;  ///< 8-bit sRGB with straight alpha
};

/// Returns the layer without its pixels beyond the canvas; without any where it lies beside it.
RasterLayer cut_to_canvas(RasterLayer layer, int width, int height);

/// Returns the area where the layer's alpha is at least one half, exact to a fraction of a pixel.
Region opaque_region(const RasterLayer& layer);

/// Returns that area as a mark with the layer's colour; nothing where the layer is nowhere opaque.
std::optional<understanding::Mark> opaque_mark(const RasterLayer& layer);

/// Adds the opaque area of a layer, cut to the canvas, as a part or a mark. A layer that is nowhere
/// opaque gives a warning. O(pixels of the layer).
void add_layer(understanding::LayeredDrawing& drawing, const RasterLayer& layer);

/// Adds the ink of a layer that darkens what lies below it, cut to the canvas, as a mark that is
/// never a part. Adds nothing where other modes blend. O(pixels of the layer).
void add_ink(understanding::LayeredDrawing& drawing, RasterLayer layer);

}  // namespace relievo

#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

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

/// One layer of a painted drawing, or one sprite.
struct RasterLayer {
  std::string name;    ///< may be empty
  int group = -1;      ///< innermost group of layers, -1: none
  int x = 0;           ///< of its left column on the canvas, px
  int y = 0;           ///< of its top row
  double opacity = 1;  ///< in [0, 1], of the layer as a whole
  LayerRole role = LayerRole::proposed;
  std::optional<double> c;  ///< of its part
  std::optional<double> d;
  std::optional<double> flat;
  std::optional<Point2> lean;
  Image8 rgba;  ///< 8-bit sRGB with straight alpha
};

/// Returns the role that a layer's name states by beginning with `texture:` or `part:`, else the
/// role of its group. A `part:` in a group of texture is texture.
LayerRole named_role(const std::string& name, LayerRole of_group);

/// Returns the name without a leading `part:`; empty where the rest is no valid id of a part.
std::string plain_layer_name(const std::string& name, LayerRole role);

/// Makes the layers without a role texture, where some layer is a part. Items have a `layer`.
template <class Item>
void settle_roles(std::vector<Item>& items) {
  const auto is_part = [](const Item& item) { return item.layer.role == LayerRole::part; };
  if (std::none_of(items.begin(), items.end(), is_part)) return;
  for (Item& item : items)
    if (item.layer.role == LayerRole::proposed) item.layer.role = LayerRole::texture;
}

/// Returns a drawing with a transparent picture of this size and no layers.
understanding::LayeredDrawing empty_drawing(int width, int height);

/// Returns the layer's opaque area (alpha of at least one half), exact to a fraction of a pixel,
/// with its colour; nothing where the layer is nowhere opaque. O(pixels of the layer).
std::optional<understanding::Mark> opaque_mark(const RasterLayer& layer);

/// Paints the layer over the drawing's picture and adds its opaque area as a part or a mark. Pixels
/// beyond the canvas are cut off. A layer that is nowhere opaque gives a warning. O(pixels of the
/// layer).
void put_layer(understanding::LayeredDrawing& drawing, const RasterLayer& layer);

}  // namespace relievo

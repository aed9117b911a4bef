#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/color.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/scene.h"
#include "understanding/marks/figures.h"

namespace relievo {

/// What a layer is to the scene.
enum class LayerRole {
  proposed,  ///< the drawing as a whole decides
  part,      ///< one part: all of it that is opaque
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

/// The role that a layer's name gives it, `texture:` or `part:` at its beginning, or the one that
/// it has from its group.
LayerRole named_role(const std::string& name, LayerRole of_group);

/// The name without its role; empty where it may name no part.
std::string plain_layer_name(const std::string& name, LayerRole role);

/// Where some layer is a part, those without a role are texture. Items have a `layer`.
template <class Item>
void settle_roles(std::vector<Item>& items) {
  const auto is_part = [](const Item& item) { return item.layer.role == LayerRole::part; };
  if (std::none_of(items.begin(), items.end(), is_part)) return;
  for (Item& item : items)
    if (item.layer.role == LayerRole::proposed) item.layer.role = LayerRole::texture;
}

/// Layers put on each other so far.
struct LayerPile {
  Image8 rgba;  ///< the picture, of the size of the canvas
  std::vector<understanding::Mark>
      marks;                ///< what is opaque of each layer that may be a part or belong to one
  std::vector<Part> parts;  ///< of the layers with the role part
  std::vector<Palette> colors;     ///< theirs
  std::vector<std::string> notes;  ///< on layers that are neither, a sentence each
};

/// A drawing with its parts.
struct LayeredDrawing {
  Scene scene;
  Drawing drawing;
  std::vector<Palette> colors;  ///< [parts]
  bool proposed = false;        ///< the parts were guessed
  std::vector<std::string> warnings;
};

LayerPile empty_pile(int width, int height);

/// Paints the layer over the pile, cut at its canvas, and takes the outline of what has an alpha
/// of at least one half, exact to a fraction of a pixel. O(pixels of the layer).
void put_layer(LayerPile& pile, const RasterLayer& layer);

/// The scene of the whole pile: the layers that are parts, else parts proposed as from vector
/// shapes. Error: bad_input where nothing opaque is drawn.
Result<LayeredDrawing> scene_of_pile(LayerPile pile);

struct LayerColor {
  Color inner;  ///< mean of what is opaque, its rim left out where there is more, with its alpha
  bool outlined = false;  ///< the rim has another colour, as where a line is drawn around a fill
};

/// What colour a layer has as a whole. O(pixels).
LayerColor color_of(const RasterLayer& layer);

}  // namespace relievo

#pragma once

#include "io/layered/layer_pile.h"
#include "io/parts/color.h"

namespace relievo {

struct LayerColor {
  Color inner;  ///< mean of what is opaque, its rim left out where there is more, with its alpha
  bool outlined = false;  ///< the rim has another colour, as where a line is drawn around a fill
};

/// What colour a layer has as a whole. O(pixels).
LayerColor color_of(const RasterLayer& layer);

}  // namespace relievo

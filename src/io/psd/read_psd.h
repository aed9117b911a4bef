#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Reads a Photoshop document of 8 or 16 bits in RGB or grey, with layers as in OpenRaster drawings
/// (see read_ora). A document without layers, or with one visible layer, is `flat`. Hidden layers
/// are left out; masks, clipping, blending and opacities apply, and what is clipped is texture.
/// Fills of one colour are painted in their masks. Adjustments and effects are left out, each with
/// a warning, unless the flattened picture in the file can be taken for them (see
/// compare_with_merged). Errors name the layer: `bad_input`, `limit`.
Result<understanding::LayeredDrawing> read_psd(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

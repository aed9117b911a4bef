#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Reads a Photoshop document of 8 or 16 bits in RGB or grey, with layers as in OpenRaster drawings
/// (see read_ora). A document without layers, or with one visible layer, is `flat`. Hidden layers
/// are left out; masks, clipping and opacities apply, and a clipped layer is texture. Every
/// blending mode is painted as normal, and adjustments and effects are left out, each with a
/// warning. Errors name the layer: `bad_input`, `limit`.
Result<understanding::LayeredDrawing> read_psd(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/image/image_limits.h"
#include "io/layered/layer_pile.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

struct PsdDrawing {
  std::optional<Drawing> flat;  ///< the picture, where it is all in one layer; else `content`
  LayeredDrawing content;
  std::vector<std::string> warnings;  ///< what is not painted as Photoshop does
};

/// Reads a Photoshop document of 8 or 16 bits in RGB or grey: its layers become parts as those of
/// an OpenRaster drawing do. Hidden layers are left out; masks, clipping and opacities hold, and
/// what is clipped is texture on what it is clipped to. Other blending than normal is painted as
/// such, adjustments and effects are left out, each with a warning. Errors name the layer:
/// bad_input, limit.
Result<PsdDrawing> read_psd(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

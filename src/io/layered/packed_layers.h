#pragma once

#include <cstdint>
#include <vector>

#include "io/image/image_limits.h"
#include "io/layered/layer_table.h"
#include "kernel/image/image_size.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Most bytes of all compressed layers of a drawing together.
constexpr uint64_t max_packed_bytes = uint64_t{1} << 30;

/// Decodes the layers, back to front, one at a time, and puts them on each other. A canvas of size
/// 0 becomes as large as the layers need. All sizes are checked first. Errors name the layer's
/// file: `bad_input` (no PNG, damaged), `limit`.
Result<understanding::LayeredDrawing> unpack_layers(const std::vector<LayerFile>& layers,
                                                    ImageSize canvas, const ImageLimits& limits);

}  // namespace relievo

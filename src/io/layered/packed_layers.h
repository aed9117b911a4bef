#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/image/image_limits.h"
#include "io/layered/layer_pile.h"
#include "io/layered/layer_table.h"
#include "kernel/image/image_size.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// All compressed layers of a drawing together hold at most this many bytes.
constexpr uint64_t max_packed_bytes = uint64_t{1} << 30;

/// A layer whose picture is not decoded yet.
struct PackedLayer {
  RasterLayer layer;  ///< without its pixels
  std::string file;   ///< for messages
  Bytes png;
};

/// The drawing that the layers, back to front, make together. The canvas is as large as the
/// layers need where its size is 0. One layer is decoded at a time; sizes are checked before.
/// Errors name the layer's file: bad_input (no PNG, damaged, nothing opaque), limit.
Result<LayeredDrawing> unpack_layers(const std::vector<PackedLayer>& layers, ImageSize canvas,
                                     const ImageLimits& limits);

}  // namespace relievo

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/image/image_limits.h"
#include "io/layered/compose_layers.h"
#include "io/layered/raster_layer.h"
#include "kernel/image/image_size.h"
#include "relievo/bytes.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// A layer that is a file of its own, and not decoded yet.
struct LayerFile {
  RasterLayer layer;  ///< without its pixels
  std::string file;   ///< its path in the folder or archive, which messages name
  double order = 0;   ///< the lowest lies at the back
  Bytes png;          ///< may not be read yet
};

constexpr size_t max_layers = 1000;

/// Reads a table of layers: lines of fields between tabs, the first with the names of the columns.
/// `file` is required; `order_back_to_front` (else the rows are in order), `name`, `x`, `y`,
/// `opacity`, `blend` (see named_blending), `role` (part, texture or empty), `c`, `d`, `flat` and
/// `lean` (two numbers) are optional; other columns are ignored. Returns the layers from back to
/// front. Errors name the line: `bad_input`, `limit` (more than `max_layers` rows).
Result<std::vector<LayerFile>> read_layer_table(std::string_view text);

/// Returns whether `p` comes before `q` in the natural order of names, with the numbers in them
/// compared by value: leg2 before leg10.
bool comes_before(const std::string& p, const std::string& q);

/// Returns a layer for each picture, named as its file without extension, back to front in the
/// natural order of the names. Error: `limit`.
Result<std::vector<LayerFile>> layers_of_names(std::vector<std::string> names);

/// Most bytes of all compressed layers of a drawing together.
constexpr uint64_t max_packed_bytes = uint64_t{1} << 30;

/// Decodes the layers, back to front, one at a time, and composes them (see compose_layers). A
/// canvas of size 0 becomes as large as the layers need. All sizes are checked first. Errors name
/// the layer's file: `bad_input` (no PNG, damaged), `limit`.
Result<understanding::LayeredDrawing> unpack_layers(const std::vector<LayerFile>& layers,
                                                    std::vector<LayerGroup> groups,
                                                    ImageSize canvas, const ImageLimits& limits);

}  // namespace relievo

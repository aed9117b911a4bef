#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/layered/raster_layer.h"
#include "relievo/result.h"

namespace relievo {

/// One row of a table of layers.
struct LayerRow {
  std::string file;   ///< relative path inside the folder
  RasterLayer layer;  ///< without its pixels
  double order = 0;   ///< the lowest lies at the back
};

constexpr size_t max_layers = 1000;

/// Reads a table of layers: lines of fields between tabs, the first with the names of the
/// columns. `file` is needed; `order_back_to_front` (else the rows are in order), `name`, `x`,
/// `y`, `opacity`, `role` (part, texture or empty), `c` and `d` are optional, other columns are
/// passed over. Rows come back sorted from back to front. Where some row is a part, the others
/// are texture. Errors name the line: bad_input, limit (more than `max_layers` rows).
Result<std::vector<LayerRow>> read_layer_table(std::string_view text);

/// The layers that pictures with these file names are, each named as its file without extension, in
/// the natural order of the names (leg2 before leg10), back to front. Error: limit.
Result<std::vector<LayerRow>> rows_of_names(std::vector<std::string> names);

}  // namespace relievo

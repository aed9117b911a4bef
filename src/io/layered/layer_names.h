#pragma once

#include <string>
#include <vector>

#include "io/layered/layer_table.h"
#include "relievo/result.h"

namespace relievo {

/// The layers that pictures with these file names are, each named as its file without extension, in
/// the natural order of the names (leg2 before leg10), back to front. Error: limit.
Result<std::vector<LayerRow>> rows_of_names(std::vector<std::string> names);

}  // namespace relievo

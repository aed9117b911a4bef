#pragma once

#include <cstdint>
#include <vector>

#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// One plane of a layer: width x height values, of which 16-bit ones keep their upper half rounded.
/// `data` begins with the way it is packed: raw, PackBits, or zlib with or without differences
/// along rows. `depth`: 8 or 16. Error: bad_input where the data is damaged. Takes memory for the
/// plane alone, whatever the data says.
Result<std::vector<uint8_t>> decode_channel(ByteView data, int width, int height, int depth);

/// The planes of the flattened picture at the end of the file, which are packed together.
Result<std::vector<std::vector<uint8_t>>> decode_merged(ByteView data, int planes, int width,
                                                        int height, int depth);

}  // namespace relievo

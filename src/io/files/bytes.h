#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace relievo {

/// The content of a file.
using Bytes = std::vector<uint8_t>;
using ByteView = std::span<const uint8_t>;

}  // namespace relievo

#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace relievo {

/// The content of a file.
using Bytes = std::vector<uint8_t>;
using ByteView = std::span<const uint8_t>;

inline Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

}  // namespace relievo

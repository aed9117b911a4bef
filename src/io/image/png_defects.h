#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "relievo/bytes.h"

namespace relievo {

/// How every PNG file begins.
constexpr std::array<uint8_t, 8> png_signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

/// Whether `bytes` begin as a PNG file does but for at most three bytes.
bool is_nearly_png(ByteView bytes);

/// What is wrong with the signature of a PNG file that does not begin as one should.
std::string signature_defect(ByteView bytes);

/// What libpng's message says of a file, with the part of the file that it is about. `bytes` have a
/// whole header.
std::string png_defect(ByteView bytes, const std::string& message);

}  // namespace relievo

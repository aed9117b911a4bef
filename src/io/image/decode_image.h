#pragma once

#include <array>
#include <cstdint>

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// A PNG, JPEG or GIF file, told apart by its content, as 8-bit sRGB with straight alpha, 4
/// channels. Errors: `bad_input` where it is none of them or damaged, `limit` where it is too
/// large.
Result<Image8> decode_image(ByteView bytes, const ImageLimits& limits = {});

/// How every PNG file begins.
constexpr std::array<uint8_t, 8> png_signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

}  // namespace relievo

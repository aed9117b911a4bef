#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Returns whether `bytes` begin like a HEIC or AVIF file.
bool is_heif(ByteView bytes);

/// Returns whether `bytes` begin like an AVIF file.
bool is_avif(ByteView bytes);

/// Decodes the main picture of a HEIC or AVIF file to 8-bit sRGB with straight alpha, 4 channels,
/// turned and cropped as the file asks. Colour profiles are ignored. Errors: `bad_input` where the
/// file is damaged or packed in a way that libheif does not read, `limit`.
Result<Image8> decode_heif(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

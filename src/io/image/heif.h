#pragma once

#include "io/image/image_limits.h"
#include "kernel/image/image_size.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Returns whether `bytes` begin like a HEIC or AVIF file.
bool is_heif(ByteView bytes);

/// Returns whether `bytes` begin like an AVIF file.
bool is_avif(ByteView bytes);

/// Reads the size of the main picture of a HEIC or AVIF file, without decoding it. Errors: as
/// decode_heif.
Result<ImageSize> heif_size(ByteView bytes, const ImageLimits& limits = {});

/// Decodes the main picture of a HEIC or AVIF file to 8-bit sRGB with straight alpha, 4 channels,
/// turned and cropped as the file asks, each pixel the average of `factor` px a side. Colour
/// profiles are ignored. Errors: `bad_input` where the file is damaged or packed in a way that
/// libheif does not read, `limit`.
Result<Image8> decode_heif(ByteView bytes, const ImageLimits& limits = {}, int factor = 1);

}  // namespace relievo

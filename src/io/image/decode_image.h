#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Decodes a PNG, JPEG, GIF, WebP, AVIF or HEIC file, recognised by its content, to 8-bit sRGB with
/// straight alpha, 4 channels, upright by its EXIF orientation. Of an animation it is the first
/// frame. Errors: `bad_input` where the file is damaged or none of them, `limit`.
Result<Image8> decode_image(ByteView bytes, const ImageLimits& limits = {});

/// Decodes a JPEG file (grey, colour or CMYK, baseline or progressive) to 8-bit sRGB with alpha
/// 255, 4 channels, upright by its EXIF orientation. Colour profiles are ignored. Errors:
/// `bad_input` where the file is damaged or cut short (the message has the reason), `limit`.
Result<Image8> decode_jpeg(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Decodes a PNG, JPEG or GIF file, recognised by its content, to 8-bit sRGB with straight alpha, 4
/// channels. Errors: `bad_input` where it is damaged or none of them, `limit`.
Result<Image8> decode_image(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

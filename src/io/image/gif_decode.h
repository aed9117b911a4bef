#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Returns whether `bytes` begin like a GIF file.
bool is_gif(ByteView bytes);

/// Decodes the first picture of a GIF file on its transparent canvas to 8-bit sRGB with straight
/// alpha, 4 channels. Errors: `bad_input` where the file is damaged or cut short (the message has
/// the reason), `limit`.
Result<Image8> decode_gif(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

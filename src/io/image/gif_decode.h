#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Whether `bytes` begin as a GIF file does.
bool is_gif(ByteView bytes);

/// The first picture of a GIF file on its canvas as 8-bit sRGB with straight alpha, 4 channels;
/// the canvas around it is transparent. Errors: `bad_input` where the file is damaged or cut short
/// (the reason is in the message), `limit`.
Result<Image8> decode_gif(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

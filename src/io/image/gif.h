#pragma once

#include <vector>

#include "io/image/image_limits.h"
#include "kernel/image/image_size.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Returns whether `bytes` begin like a GIF file.
bool is_gif(ByteView bytes);

/// Reads the size in the header of a GIF file, without decoding it. Errors: as decode_gif.
Result<ImageSize> gif_size(ByteView bytes, const ImageLimits& limits = {});

/// Decodes the first picture of a GIF file on its transparent canvas to 8-bit sRGB with straight
/// alpha, 4 channels. Errors: `bad_input` where the file is damaged or cut short (the message has
/// the reason), `limit`.
Result<Image8> decode_gif(ByteView bytes, const ImageLimits& limits = {});

/// Counts the pictures of a GIF file, up to the first damage, without decoding them.
size_t gif_frame_count(ByteView bytes);

/// Decodes all frames of a GIF file, each as a player shows it. Errors: as decode_gif.
Result<std::vector<Image8>> decode_gif_frames(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

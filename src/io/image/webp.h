#pragma once

#include <vector>

#include "io/image/image_limits.h"
#include "kernel/image/image_size.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Returns whether `bytes` begin like a WebP file.
bool is_webp(ByteView bytes);

/// Reads the size in the header of a WebP file, without decoding it. Errors: as decode_webp.
Result<ImageSize> webp_size(ByteView bytes, const ImageLimits& limits = {});

/// Decodes a WebP file, or the first frame of an animated one, to 8-bit sRGB with straight alpha, 4
/// channels, upright by its EXIF orientation, each pixel the average of `factor` px a side. Errors:
/// `bad_input` where the file is damaged or cut short, `limit`.
Result<Image8> decode_webp(ByteView bytes, const ImageLimits& limits = {}, int factor = 1);

/// Counts the frames of a WebP file; 0 where it is damaged.
size_t webp_frame_count(ByteView bytes);

/// Decodes all frames of a WebP file, each as a player shows it. Errors: as decode_webp.
Result<std::vector<Image8>> decode_webp_frames(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

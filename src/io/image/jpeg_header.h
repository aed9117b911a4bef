#pragma once

#include "io/image/image_limits.h"
#include "kernel/image/image_size.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// Returns whether `bytes` begin like a JPEG file.
bool is_jpeg(ByteView bytes);

/// Returns the size in the first frame header of a JPEG file, without decoding it. Errors:
/// `bad_input` where there is none, `limit`.
Result<ImageSize> jpeg_size(ByteView bytes, const ImageLimits& limits);

}  // namespace relievo

#pragma once

#include <string>
#include <vector>

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Returns the number of frames of an animated GIF, PNG or WebP file; 1 for other files.
size_t frame_count(ByteView bytes);

/// Returns the warning that only the first of several frames is read, and what to do about it;
/// empty where there is one frame.
std::string first_frame_warning(ByteView bytes);

/// Returns an error on the pixels of a picture. Of a file with several frames it says that the
/// first one is meant.
Error in_first_frame(Error error, ByteView bytes);

/// Decodes the frames of an animated GIF or WebP file, each as a player shows it. Errors: those of
/// decode_image, `bad_input` for animated PNG files, and `limit` where all frames together have
/// more pixels than one picture may have.
Result<std::vector<Image8>> decode_frames(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo

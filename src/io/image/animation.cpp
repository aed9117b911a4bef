#include "io/image/animation.h"

#include <algorithm>

#include "io/image/gif.h"
#include "io/image/png.h"
#include "io/image/webp.h"

namespace relievo {
namespace {

constexpr const char* no_frames =
    "its frames cannot be taken apart; save it as GIF or WebP, or its frames as PNG files";

}  // namespace

size_t frame_count(ByteView bytes) {
  size_t count = 1;
  if (is_gif(bytes)) count = gif_frame_count(bytes);
  if (is_webp(bytes)) count = webp_frame_count(bytes);
  if (is_png(bytes)) count = png_frame_count(bytes);
  return std::max<size_t>(count, 1);
}

std::string first_frame_warning(ByteView bytes) {
  const size_t count = frame_count(bytes);
  if (count == 1) return "";
  return "the first of " + std::to_string(count) + " frames is used; " +
         (is_png(bytes) ? std::string("to take all, save the frames as files for relievo sequence")
                        : "relievo sequence takes all");
}

Error in_first_frame(Error error, ByteView bytes) {
  const std::string warning = first_frame_warning(bytes);
  if (!warning.empty() && error.code == ErrorCode::bad_input)
    error.message = warning + "; " + error.message;
  return error;
}

Result<std::vector<Image8>> decode_frames(ByteView bytes, const ImageLimits& limits) {
  if (is_png(bytes)) return Error{ErrorCode::bad_input, no_frames, ""};
  const size_t count = frame_count(bytes);
  ImageLimits each = limits;
  each.max_pixels = limits.max_pixels / static_cast<int64_t>(count);
  auto frames = is_gif(bytes) ? decode_gif_frames(bytes, each) : decode_webp_frames(bytes, each);
  if (frames || frames.error().code != ErrorCode::limit) return frames;
  return Error{ErrorCode::limit,
               "its " + std::to_string(count) + " frames have more than " +
                   megapixels(limits.max_pixels) + " together; make them smaller or fewer",
               ""};
}

}  // namespace relievo

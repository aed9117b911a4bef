#include "io/image/decode_image.h"

#include "io/image/gif_decode.h"
#include "io/image/jpeg_decode.h"
#include "io/image/png.h"

namespace relievo {

Result<Image8> decode_image(ByteView bytes, const ImageLimits& limits) {
  if (is_png(bytes)) return decode_png(bytes, limits);
  if (is_jpeg(bytes)) return decode_jpeg(bytes, limits);
  if (is_gif(bytes)) return decode_gif(bytes, limits);
  if (is_nearly_png(bytes)) return decode_png(bytes, limits);  // which names the defect
  return Error{ErrorCode::bad_input, "is neither a PNG nor a JPEG nor a GIF picture", ""};
}

}  // namespace relievo

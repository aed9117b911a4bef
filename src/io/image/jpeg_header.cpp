#include "io/image/jpeg_header.h"

#include <cstddef>
#include <cstdint>

namespace relievo {

bool is_jpeg(ByteView bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

Result<ImageSize> jpeg_size(ByteView bytes, const ImageLimits& limits) {
  const auto number = [&](size_t i) { return bytes[i] << 8 | bytes[i + 1]; };
  for (size_t at = 2; at + 9 < bytes.size() && bytes[at] == 0xff;) {
    const uint8_t marker = bytes[at + 1];
    // The markers C0 to CF begin frames, except these three, which hold tables.
    const bool is_frame =
        (marker & 0xf0) == 0xc0 && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (!is_frame) {
      at += marker == 0xff ? 1 : 2 + static_cast<size_t>(number(at + 2));
      continue;
    }
    const ImageSize size{number(at + 7), number(at + 5)};
    if (Status status = check_image_size(size.width, size.height, limits); !status)
      return status.error();
    return size;
  }
  return damaged_image("JPEG", "it has no size");
}

}  // namespace relievo

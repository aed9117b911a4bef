#include "io/image/orientation.h"

#include <algorithm>
#include <cstring>

namespace relievo {
namespace {

constexpr uint32_t orientation_tag = 0x0112;
constexpr uint32_t type_short = 3;

/// Reads numbers of a TIFF block; those beyond its end are 0.
struct TiffView {
  ByteView bytes;
  bool big_endian = false;

  uint32_t byte(size_t at) const { return at < bytes.size() ? bytes[at] : 0; }
  uint32_t u16(size_t at) const {
    return big_endian ? byte(at) << 8 | byte(at + 1) : byte(at + 1) << 8 | byte(at);
  }
  uint32_t u32(size_t at) const {
    return big_endian ? u16(at) << 16 | u16(at + 2) : u16(at + 2) << 16 | u16(at);
  }
};

}  // namespace

int exif_orientation(ByteView exif) {
  constexpr size_t name_size = 6;
  if (exif.size() >= name_size && std::memcmp(exif.data(), "Exif\0\0", name_size) == 0)
    exif = exif.subspan(name_size);
  if (exif.size() < 8 || exif[0] != exif[1] || (exif[0] != 'M' && exif[0] != 'I')) return 1;
  const TiffView tiff{exif, exif[0] == 'M'};
  if (tiff.u16(2) != 42) return 1;
  const size_t directory = tiff.u32(4);
  const uint32_t count = tiff.u16(directory);
  for (uint32_t i = 0; i < count; ++i) {
    const size_t entry = directory + 2 + size_t{12} * i;
    if (entry >= tiff.bytes.size()) break;
    if (tiff.u16(entry) != orientation_tag || tiff.u16(entry + 2) != type_short) continue;
    const uint32_t value = tiff.u16(entry + 8);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

Image8 upright(Image8 image, int orientation) {
  if (orientation == 1) return image;
  const bool transposed = orientation >= 5;
  const bool mirrored_x =
      orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool mirrored_y =
      orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  Image8 result(transposed ? image.height : image.width, transposed ? image.width : image.height,
                image.channels);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      int from_x = transposed ? y : x;
      int from_y = transposed ? x : y;
      if (mirrored_x) from_x = image.width - 1 - from_x;
      if (mirrored_y) from_y = image.height - 1 - from_y;
      for (int c = 0; c < image.channels; ++c) result.at(x, y, c) = image.at(from_x, from_y, c);
    }
  return result;
}

}  // namespace relievo

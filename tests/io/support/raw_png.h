#pragma once

#include <png.h>

#include <cstring>
#include <map>
#include <string>

#include "relievo/bytes.h"
#include "relievo/image.h"

namespace relievo {

/// A PNG file's samples as they are stored, read by libpng without any of our code.
struct RawPng {
  Image16 samples;
  int bit_depth = 0;
  std::map<std::string, std::string> texts;
};

inline RawPng read_raw_png(ByteView bytes) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_read_fn(png, &bytes, [](png_structp reader, png_bytep out, size_t count) {
    auto* rest = static_cast<ByteView*>(png_get_io_ptr(reader));
    std::memcpy(out, rest->data(), count);
    *rest = rest->subspan(count);
  });
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  RawPng raw;
  raw.bit_depth = png_get_bit_depth(png, info);
  raw.samples =
      Image16(static_cast<int>(png_get_image_width(png, info)),
              static_cast<int>(png_get_image_height(png, info)), png_get_channels(png, info));
  const size_t row_samples = static_cast<size_t>(raw.samples.width) * raw.samples.channels;
  for (int y = 0; y < raw.samples.height; ++y) {
    const png_bytep row = png_get_rows(png, info)[y];
    for (size_t i = 0; i < row_samples; ++i)
      (&raw.samples.at(0, y))[i] =
          static_cast<uint16_t>(raw.bit_depth == 16 ? row[2 * i] << 8 | row[2 * i + 1] : row[i]);
  }
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(png, info, &texts, &count);
  for (int i = 0; i < count; ++i) raw.texts[texts[i].key] = texts[i].text;
  png_destroy_read_struct(&png, &info, nullptr);
  return raw;
}

}  // namespace relievo

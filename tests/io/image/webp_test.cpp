#include "io/image/webp.h"

#include <gtest/gtest.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include "io/image/decode_image.h"
#include "io/image/orientation.h"

namespace relievo {
namespace {

/// Colours and alphas that differ from pixel to pixel.
Image8 webp_pattern(int width, int height) {
  Image8 image(width, height, 4);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<uint8_t>(i % 4 == 3 ? 255 - i % 97 : 7 * i);
  return image;
}

Bytes encode_lossless(const Image8& image) {
  uint8_t* data = nullptr;
  const size_t size = WebPEncodeLosslessRGBA(image.pixels.data(), image.width, image.height,
                                             4 * image.width, &data);
  Bytes bytes(data, data + size);
  WebPFree(data);
  return bytes;
}

Bytes with_exif(const Bytes& webp, const Bytes& exif) {
  const WebPData file = {webp.data(), webp.size()};
  const WebPData chunk = {exif.data(), exif.size()};
  WebPMux* mux = WebPMuxCreate(&file, 1);
  WebPMuxSetChunk(mux, "EXIF", &chunk, 1);
  WebPData data;
  WebPMuxAssemble(mux, &data);
  WebPMuxDelete(mux);
  Bytes bytes(data.bytes, data.bytes + data.size);
  WebPDataClear(&data);
  return bytes;
}

TEST(Webp, PixelsComeBack) {
  const Image8 image = webp_pattern(19, 7);
  const auto decoded = decode_image(encode_lossless(image));
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(decoded->width, 19);
  EXPECT_EQ(decoded->pixels, image.pixels);
}

TEST(Webp, ExifOrientationIsApplied) {
  const Image8 image = webp_pattern(6, 4);
  const Bytes exif = {'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0,
                      3,   0,   0, 0,  1, 0, 6, 0, 0, 0, 0, 0,    0};
  const auto decoded = decode_webp(with_exif(encode_lossless(image), exif));
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(decoded->width, 4);
  EXPECT_EQ(decoded->pixels, upright(image, 6).pixels);
}

TEST(Webp, TruncationsAndHugeSizesAreRefused) {
  const Bytes webp = encode_lossless(webp_pattern(40, 30));
  for (size_t size = 0; size < webp.size(); size += 5)
    EXPECT_FALSE(decode_webp(ByteView(webp).first(size))) << size;
  EXPECT_EQ(decode_webp(webp, {40 * 30 - 1, 100}).error().code, ErrorCode::limit);
  EXPECT_TRUE(decode_webp(webp, {40 * 30, 100}));
}

}  // namespace
}  // namespace relievo

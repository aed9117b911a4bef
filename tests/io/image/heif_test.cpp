#include "io/image/heif.h"

#include <gtest/gtest.h>
#include <libheif/heif.h>

#include <algorithm>

#include "io/image/decode_image.h"
#include "io/support/damage.h"

namespace relievo {
namespace {

heif_error append_heif(heif_context*, const void* data, size_t size, void* out) {
  const auto* bytes = static_cast<const uint8_t*>(data);
  static_cast<Bytes*>(out)->insert(static_cast<Bytes*>(out)->end(), bytes, bytes + size);
  return {heif_error_Ok, heif_suberror_Unspecified, ""};
}

constexpr int heif_width = 64;
constexpr int heif_height = 48;

/// Encodes a picture whose left half is red and whose right half is blue; empty where libheif has
/// no encoder.
Bytes encode_heif(heif_compression_format format) {
  heif_image* image = nullptr;
  heif_image_create(heif_width, heif_height, heif_colorspace_RGB, heif_chroma_interleaved_RGB,
                    &image);
  heif_image_add_plane(image, heif_channel_interleaved, heif_width, heif_height, 8);
  int stride = 0;
  uint8_t* rows = heif_image_get_plane(image, heif_channel_interleaved, &stride);
  for (int y = 0; y < heif_height; ++y)
    for (int x = 0; x < heif_width; ++x) {
      uint8_t* pixel = rows + y * stride + 3 * x;
      pixel[0] = x < heif_width / 2 ? 230 : 20;
      pixel[1] = 20;
      pixel[2] = x < heif_width / 2 ? 20 : 230;
    }
  heif_context* context = heif_context_alloc();
  heif_encoder* encoder = nullptr;
  Bytes bytes;
  if (heif_context_get_encoder_for_format(context, format, &encoder).code == heif_error_Ok) {
    heif_encoder_set_lossy_quality(encoder, 90);
    heif_context_encode_image(context, image, encoder, nullptr, nullptr);
    heif_writer writer = {1, append_heif};
    heif_context_write(context, &writer, &bytes);
    heif_encoder_release(encoder);
  }
  heif_image_release(image);
  heif_context_free(context);
  return bytes;
}

class Heif : public ::testing::TestWithParam<heif_compression_format> {};

TEST_P(Heif, PicturesAreDecoded) {
  const Bytes file = encode_heif(GetParam());
  if (file.empty()) GTEST_SKIP() << "libheif has no encoder";
  EXPECT_TRUE(is_heif(file));
  EXPECT_EQ(is_avif(file), GetParam() == heif_compression_AV1);
  const auto image = decode_image(file);
  ASSERT_TRUE(image) << to_string(image.error());
  ASSERT_EQ(image->width, heif_width);
  ASSERT_EQ(image->height, heif_height);
  EXPECT_GT(image->at(8, 24, 0), 180);
  EXPECT_LT(image->at(8, 24, 2), 80);
  EXPECT_GT(image->at(heif_width - 8, 24, 2), 180);
  EXPECT_EQ(image->at(8, 24, 3), 255);
  EXPECT_EQ(decode_heif(file, {heif_width * heif_height - 1, 100}).error().code, ErrorCode::limit);
}

TEST_P(Heif, DamageGivesAnErrorThatSaysSomething) {
  const Bytes file = encode_heif(GetParam());
  if (file.empty()) GTEST_SKIP() << "libheif has no encoder";
  survive_damage(file, 100, [](ByteView bytes) { return decode_heif(bytes, {1 << 20, 1 << 14}); });
  EXPECT_FALSE(decode_heif(ByteView(file).first(file.size() / 2)));
}

INSTANTIATE_TEST_SUITE_P(Kinds, Heif,
                         ::testing::Values(heif_compression_HEVC, heif_compression_AV1));

}  // namespace
}  // namespace relievo

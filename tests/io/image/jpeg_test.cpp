#include <gtest/gtest.h>

#include "io/image/decode_image.h"
#include "io/image/orientation.h"
#include "io/support/encode_jpeg.h"

namespace relievo {
namespace {

/// A smooth gradient: red grows to the right, green downwards.
Image8 gradient(int width, int height, int channels) {
  Image8 image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        image.at(x, y, c) = static_cast<uint8_t>(c == 1 ? 255 * y / height : 255 * x / width);
  return image;
}

Bytes exif_block(uint8_t orientation, bool big_endian) {
  if (big_endian)
    return {'E', 'x',  'i', 'f', 0, 0, 'M', 'M', 0, 42,          0, 0, 0, 8, 0, 1,
            1,   0x12, 0,   3,   0, 0, 0,   1,   0, orientation, 0, 0, 0, 0, 0, 0};
  return {'E',  'x', 'i', 'f', 0, 0, 'I', 'I', 42,          0, 8, 0, 0, 0, 1, 0,
          0x12, 1,   3,   0,   1, 0, 0,   0,   orientation, 0, 0, 0, 0, 0, 0, 0};
}

TEST(Jpeg, ColourAndGreyComeBackNearly) {
  for (const bool progressive : {false, true}) {
    const Image8 rgb = gradient(40, 30, 3);
    const Result<Image8> colour = decode_image(encode_jpeg(rgb, {JCS_RGB, progressive, {}}));
    ASSERT_TRUE(colour.ok());
    const Image8 grey = gradient(40, 30, 1);
    const Result<Image8> single = decode_image(encode_jpeg(grey, {JCS_GRAYSCALE, progressive, {}}));
    ASSERT_TRUE(single.ok());
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x) {
        for (int c = 0; c < 3; ++c) {
          ASSERT_NEAR(colour->at(x, y, c), rgb.at(x, y, c), 16);
          ASSERT_NEAR(single->at(x, y, c), grey.at(x, y), 8);
        }
        ASSERT_EQ(colour->at(x, y, 3), 255);
        ASSERT_EQ(single->at(x, y, 3), 255);
      }
  }
}

TEST(Jpeg, CmykBecomesLight) {
  Image8 ink(16, 16, 4);
  for (size_t i = 0; i < ink.pixels.size(); i += 4) {
    const std::array<uint8_t, 4> stored = {255, 0, 255, 128};  // Adobe: 255 - ink, so magenta
    std::copy(stored.begin(), stored.end(), &ink.pixels[i]);
  }
  const Result<Image8> image = decode_jpeg(encode_jpeg(ink, {JCS_CMYK, false, {}}));
  ASSERT_TRUE(image.ok());
  EXPECT_NEAR(image->at(8, 8, 0), 128, 4);
  EXPECT_NEAR(image->at(8, 8, 1), 0, 4);
  EXPECT_NEAR(image->at(8, 8, 2), 128, 4);
  EXPECT_EQ(image->at(8, 8, 3), 255);
}

TEST(Jpeg, ExifOrientationIsApplied) {
  const Image8 image = gradient(32, 16, 3);
  for (const bool big_endian : {false, true})
    for (int orientation = 1; orientation <= 8; ++orientation) {
      const Bytes exif = exif_block(static_cast<uint8_t>(orientation), big_endian);
      ASSERT_EQ(exif_orientation(exif), orientation);
      const Result<Image8> turned = decode_jpeg(encode_jpeg(image, {JCS_RGB, false, exif}));
      const Result<Image8> plain = decode_jpeg(encode_jpeg(image, {JCS_RGB, false, {}}));
      ASSERT_TRUE(turned.ok());
      EXPECT_EQ(turned->width, orientation >= 5 ? 16 : 32);
      EXPECT_EQ(turned->pixels, upright(*plain, orientation).pixels);
    }
}

TEST(Jpeg, UprightFollowsTheExifDefinition) {
  Image8 image(3, 2, 1);
  image.pixels = {1, 2, 3, 4, 5, 6};
  const std::vector<std::vector<uint8_t>> expected = {
      {1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1}, {4, 5, 6, 1, 2, 3},
      {1, 4, 2, 5, 3, 6}, {4, 1, 5, 2, 6, 3}, {6, 3, 5, 2, 4, 1}, {3, 6, 2, 5, 1, 4}};
  for (int orientation = 1; orientation <= 8; ++orientation)
    EXPECT_EQ(upright(image, orientation).pixels, expected[orientation - 1]) << orientation;
}

TEST(Jpeg, DamagedExifIsIgnored) {
  const Bytes exif = exif_block(6, false);
  for (size_t size = 0; size < 24; ++size)
    EXPECT_EQ(exif_orientation(ByteView(exif).first(size)), 1) << size;
  EXPECT_EQ(exif_orientation(exif_block(9, true)), 1);
  Bytes far_away = exif_block(6, false);
  far_away[13] = 0xff;
  EXPECT_EQ(exif_orientation(far_away), 1);
}

TEST(Jpeg, TruncatedFilesAreRefused) {
  for (const bool progressive : {false, true}) {
    const Bytes jpeg = encode_jpeg(gradient(24, 24, 3), {JCS_RGB, progressive, {}});
    for (size_t size = 0; size + 2 < jpeg.size(); ++size) {
      const Result<Image8> refused = decode_jpeg(ByteView(jpeg).first(size));
      ASSERT_FALSE(refused.ok()) << size;
      EXPECT_EQ(refused.error().code, ErrorCode::bad_input);
    }
  }
}

TEST(Jpeg, FlippedBitsGiveAnImageOrAnError) {
  const Bytes jpeg = encode_jpeg(gradient(16, 16, 3), {});
  int decoded = 0;
  for (size_t bit = 0; bit < 8 * jpeg.size(); ++bit) {
    Bytes damaged = jpeg;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ (1 << bit % 8));
    decoded += decode_jpeg(damaged, {1 << 20, 1 << 14}).ok() ? 1 : 0;
  }
  EXPECT_GT(decoded, 0);
  EXPECT_LT(decoded, static_cast<int>(8 * jpeg.size()));
}

/// Seeds of each kind: colours, grey, inks, baseline and progressive, turned.
TEST(Jpeg, DamageOfTenSeedsNeverCrashes) {
  int seeds = 0;
  for (const bool progressive : {false, true})
    for (const int size : {8, 17, 40}) {
      const Bytes exif = exif_block(static_cast<uint8_t>(1 + seeds % 8), progressive);
      for (const auto& [channels, space] :
           {std::pair(3, JCS_RGB), std::pair(1, JCS_GRAYSCALE), std::pair(4, JCS_CMYK)}) {
        ++seeds;
        const Bytes good =
            encode_jpeg(gradient(size, size + 3, channels), {space, progressive, exif});
        const Result<Image8> image = decode_jpeg(good);
        ASSERT_TRUE(image.ok());
        for (size_t cut = 0; cut + 2 < good.size(); cut += 5)
          EXPECT_FALSE(decode_jpeg(ByteView(good).first(cut)).ok());
        for (size_t bit = 0; bit < 8 * good.size(); bit += 13) {
          Bytes damaged = good;
          damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ (1 << bit % 8));
          const Result<Image8> result = decode_jpeg(damaged, {1 << 20, 1 << 14});
          EXPECT_TRUE(result.ok() || !result.error().message.empty());
        }
      }
    }
  EXPECT_GE(seeds, 10);
}

TEST(Jpeg, HugeSizesAreRefusedBeforePixelsTakeMemory) {
  Bytes jpeg = encode_jpeg(gradient(16, 16, 3), {});
  size_t frame = 0;
  while (jpeg[frame] != 0xff || jpeg[frame + 1] != 0xc0) ++frame;
  const auto resize = [&](uint8_t high) { jpeg[frame + 5] = jpeg[frame + 7] = high; };
  resize(0x7f);
  EXPECT_EQ(decode_jpeg(jpeg).error().code, ErrorCode::limit);
  resize(0x26);
  EXPECT_EQ(decode_jpeg(jpeg).error().code, ErrorCode::bad_input);
}

}  // namespace
}  // namespace relievo

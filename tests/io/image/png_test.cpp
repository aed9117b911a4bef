#include "io/image/png.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>

#include "io/image/decode_image.h"
#include "io/image/orientation.h"
#include "io/support/raw_png.h"

namespace relievo {
namespace {

Image8 pattern(int width, int height, int channels) {
  Image8 image(width, height, channels);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<uint8_t>(i * i / 7 + 31 * i);
  return image;
}

void append_big_endian(Bytes& bytes, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<uint8_t>(value >> shift));
}

/// The first 33 bytes of a PNG file: signature and header.
Bytes png_header(uint32_t width, uint32_t height) {
  Bytes bytes = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
  append_big_endian(bytes, width);
  append_big_endian(bytes, height);
  for (const uint8_t byte : Bytes{8, 6, 0, 0, 0}) bytes.push_back(byte);
  append_big_endian(bytes, static_cast<uint32_t>(crc32(0, &bytes[12], 17)));
  return bytes;
}

/// The file with another chunk behind its header.
Bytes with_chunk(Bytes png, const char* name, const Bytes& content) {
  Bytes chunk;
  append_big_endian(chunk, static_cast<uint32_t>(content.size()));
  chunk.insert(chunk.end(), name, name + 4);
  chunk.insert(chunk.end(), content.begin(), content.end());
  append_big_endian(
      chunk, static_cast<uint32_t>(crc32(0, &chunk[4], static_cast<uInt>(content.size() + 4))));
  png.insert(png.begin() + 33, chunk.begin(), chunk.end());
  return png;
}

TEST(Png, ExifOrientationIsAppliedToPictures) {
  const Image8 image = pattern(5, 3, 4);
  const Bytes png = *encode_png(image);
  for (uint8_t orientation = 1; orientation <= 8; ++orientation) {
    const Bytes exif = {'I', 'I', 42, 0, 8, 0,           0, 0, 1, 0, 0x12, 1, 3,
                        0,   1,   0,  0, 0, orientation, 0, 0, 0, 0, 0,    0};
    const auto decoded = decode_image(with_chunk(png, "eXIf", exif));
    ASSERT_TRUE(decoded) << to_string(decoded.error());
    EXPECT_EQ(decoded->pixels, upright(image, orientation).pixels) << int{orientation};
  }
  EXPECT_EQ(png_orientation(png), 1);
  EXPECT_EQ(png_orientation(with_chunk(png, "eXIf", {})), 1);
  EXPECT_EQ(png_orientation(ByteView(png).first(10)), 1);
}

TEST(Png, RgbaRoundTrip) {
  const Image8 image = pattern(37, 23, 4);
  const Result<Bytes> png = encode_png(image);
  ASSERT_TRUE(png.ok());
  const Result<Image8> decoded = decode_image(*png);
  ASSERT_TRUE(decoded.ok()) << to_string(decoded.error());
  EXPECT_EQ(decoded->pixels, image.pixels);
}

TEST(Png, DamageIsToldInWords) {
  const Bytes sound = *encode_png(pattern(5, 4, 4));
  const auto reason = [&](size_t at, uint8_t value) {
    Bytes bytes = sound;
    bytes[at] = value;
    const Result<Image8> image = decode_image(bytes);
    return image.ok() ? std::string() : image.error().message;
  };
  const auto tells = [](const std::string& message, const char* words) {
    return message.find(words) != std::string::npos;
  };
  EXPECT_TRUE(tells(reason(2, 'n'), "byte 3 of its signature is wrong"));
  EXPECT_TRUE(tells(reason(4, '\n'), "line ends"));
  EXPECT_TRUE(tells(reason(30, static_cast<uint8_t>(~sound[30])), "checksum of its header (IHDR)"));
  const auto header = [](uint8_t depth, uint8_t type) {
    Bytes bytes = png_header(5, 4);
    bytes[24] = depth;
    bytes[25] = type;
    bytes.resize(29);
    append_big_endian(bytes, static_cast<uint32_t>(crc32(0, &bytes[12], 17)));
    return decode_image(bytes).error().message;
  };
  EXPECT_TRUE(tells(header(8, 5), "there is no colour type 5"));
  EXPECT_TRUE(tells(header(16, 3), "colour type 3 has no bit depth of 16"));
}

TEST(Png, ValuesAreReadAsTheyAre) {
  Image16 deep(9, 7, 1);
  for (size_t i = 0; i < deep.pixels.size(); ++i) deep.pixels[i] = static_cast<uint16_t>(i * 997);
  const auto read_deep = decode_png_values(*encode_png(deep));
  ASSERT_TRUE(read_deep.ok());
  EXPECT_EQ(read_deep->pixels, deep.pixels);
  const Image8 shallow = pattern(9, 7, 1);
  const auto read_shallow = decode_png_values(*encode_png(shallow));
  ASSERT_TRUE(read_shallow.ok());
  EXPECT_TRUE(
      std::equal(shallow.pixels.begin(), shallow.pixels.end(), read_shallow->pixels.begin()));
  const auto colours = decode_png_values(*encode_png(pattern(9, 7, 3)));
  ASSERT_FALSE(colours.ok());
  EXPECT_EQ(colours.error().code, ErrorCode::bad_input);
}

TEST(Png, OtherChannelCountsExpandToOpaque) {
  for (const int channels : {1, 3}) {
    const Image8 image = pattern(19, 5, channels);
    const Result<Image8> decoded = decode_png(*encode_png(image));
    ASSERT_TRUE(decoded.ok());
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        for (int c = 0; c < 3; ++c)
          ASSERT_EQ(decoded->at(x, y, c), image.at(x, y, channels == 1 ? 0 : c));
        ASSERT_EQ(decoded->at(x, y, 3), 255);
      }
  }
}

TEST(Png, SixteenBitGreyIsStoredExactly) {
  Image16 image(64, 4, 1);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<uint16_t>(i * 257 + 3);
  const Result<Bytes> png = encode_png(image, {{"height_scale", "0.125"}});
  ASSERT_TRUE(png.ok());
  const RawPng raw = read_raw_png(*png);
  EXPECT_EQ(raw.bit_depth, 16);
  EXPECT_EQ(raw.samples.pixels, image.pixels);
  EXPECT_EQ(raw.texts.at("height_scale"), "0.125");
}

TEST(Png, SameImageGivesSameBytes) {
  EXPECT_EQ(*encode_png(pattern(50, 40, 3)), *encode_png(pattern(50, 40, 3)));
}

TEST(Png, RefusesToEncodeNothing) {
  EXPECT_EQ(encode_png(Image8{}).error().code, ErrorCode::bad_input);
  EXPECT_EQ(encode_png(Image8(3, 3, 2)).error().code, ErrorCode::bad_input);
}

TEST(Png, TruncationAtEveryByteIsRefused) {
  const Bytes png = *encode_png(pattern(9, 7, 4));
  for (size_t size = 0; size < png.size(); ++size) {
    const Result<Image8> refused = decode_png(ByteView(png).first(size));
    ASSERT_FALSE(refused.ok()) << size;
    EXPECT_EQ(refused.error().code, ErrorCode::bad_input);
    EXPECT_FALSE(refused.error().message.empty());
  }
}

TEST(Png, FlippedBitsGiveAnImageOrAnError) {
  const Bytes png = *encode_png(pattern(9, 7, 4));
  int refused = 0;
  for (size_t bit = 0; bit < 8 * png.size(); ++bit) {
    Bytes damaged = png;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ (1 << bit % 8));
    refused += decode_png(damaged, {1 << 20, 1 << 14}).ok() ? 0 : 1;
  }
  EXPECT_GT(refused, static_cast<int>(7 * png.size()));
}

TEST(Png, HugeSizesAreRefusedFromTheHeader) {
  for (const auto& [width, height] :
       {std::pair(65535U, 65535U), {0x7fffffffU, 1U}, {20000U, 20000U}, {0xffffffffU, 2U}}) {
    const Result<Image8> refused = decode_png(png_header(width, height));
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::limit);
  }
  EXPECT_EQ(decode_png(png_header(0, 5)).error().code, ErrorCode::bad_input);
}

TEST(Png, AllowedSizeWithoutThePixelsToFillItIsRefused) {
  const Result<Image8> refused = decode_png(png_header(10000, 10000));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::bad_input);
}

TEST(Png, LimitsAreTheCallers) {
  const Bytes png = *encode_png(pattern(10, 10, 4));
  EXPECT_TRUE(decode_png(png, {100, 10}).ok());
  EXPECT_EQ(decode_png(png, {99, 10}).error().code, ErrorCode::limit);
  EXPECT_EQ(decode_png(png, {100, 9}).error().code, ErrorCode::limit);
}

TEST(DecodeImage, RefusesOtherContents) {
  const Bytes gif = {'G', 'I', 'F', '8', '9', 'a', 0, 0};
  EXPECT_EQ(decode_image(gif).error().code, ErrorCode::bad_input);
  EXPECT_EQ(decode_image({}).error().code, ErrorCode::bad_input);
}

}  // namespace
}  // namespace relievo

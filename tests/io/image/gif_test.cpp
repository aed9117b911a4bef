#include "io/image/gif.h"

#include <gif_lib.h>
#include <gtest/gtest.h>

#include <array>

#include "io/image/decode_image.h"
#include "io/support/damage.h"

namespace relievo {
namespace {

int append(GifFileType* gif, const GifByteType* bytes, int count) {
  auto* out = static_cast<Bytes*>(gif->UserData);
  out->insert(out->end(), bytes, bytes + count);
  return count;
}

struct GifOptions {
  bool interlaced = false;
  int transparent = NO_TRANSPARENT_COLOR;
  int left = 0, top = 0;  ///< of the picture on a canvas that is 2 px larger
};

constexpr int gif_width = 19;
constexpr int gif_height = 23;

uint8_t index_at(int x, int y) { return static_cast<uint8_t>((3 * x + 5 * y) % 8); }

Bytes encode_gif(const GifOptions& options) {
  Bytes bytes;
  int error = 0;
  GifFileType* gif = EGifOpen(&bytes, append, &error);
  ColorMapObject* colors = GifMakeMapObject(8, nullptr);
  for (int k = 0; k < 8; ++k)
    colors->Colors[k] = {static_cast<uint8_t>(30 * k), static_cast<uint8_t>(200 - k), 7};
  EGifSetGifVersion(gif, true);
  EGifPutScreenDesc(gif, gif_width + 2, gif_height + 2, 8, 0, colors);
  const GraphicsControlBlock control = {DISPOSAL_UNSPECIFIED, false, 0, options.transparent};
  std::array<GifByteType, 4> block = {};
  EGifGCBToExtension(&control, block.data());
  EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, 4, block.data());
  EGifPutImageDesc(gif, options.left, options.top, gif_width, gif_height, options.interlaced,
                   nullptr);
  std::vector<int> rows;
  const int passes[4][2] = {{0, 8}, {4, 8}, {2, 4}, {1, 2}};
  if (options.interlaced)
    for (const auto& pass : passes)
      for (int y = pass[0]; y < gif_height; y += pass[1]) rows.push_back(y);
  else
    for (int y = 0; y < gif_height; ++y) rows.push_back(y);
  for (const int y : rows) {
    std::array<GifPixelType, gif_width> line = {};
    for (int x = 0; x < gif_width; ++x) line[x] = index_at(x, y);
    EGifPutLine(gif, line.data(), gif_width);
  }
  GifFreeMapObject(colors);
  EGifCloseFile(gif, &error);
  return bytes;
}

TEST(Gif, PixelsComeBack) {
  for (const bool interlaced : {false, true}) {
    const Result<Image8> image = decode_image(encode_gif({interlaced, 3, 1, 2}));
    ASSERT_TRUE(image.ok()) << to_string(image.error());
    ASSERT_EQ(image->width, gif_width + 2);
    ASSERT_EQ(image->height, gif_height + 2);
    EXPECT_EQ(image->at(0, 5, 3), 0);
    for (int y = 0; y < gif_height; ++y)
      for (int x = 0; x < gif_width; ++x) {
        const uint8_t k = index_at(x, y);
        EXPECT_EQ(image->at(x + 1, y + 2, 0), 30 * k);
        EXPECT_EQ(image->at(x + 1, y + 2, 1), 200 - k);
        EXPECT_EQ(image->at(x + 1, y + 2, 3), k == 3 ? 0 : 255);
      }
  }
}

TEST(Gif, TruncationsAreRefused) {
  const Bytes gif = encode_gif({});
  size_t opened = 0;
  for (size_t size = 0; size < gif.size(); ++size) {
    const Result<Image8> image = decode_gif(ByteView(gif).first(size));
    if (image.ok()) {
      ++opened;
      continue;
    }
    EXPECT_EQ(image.error().code, ErrorCode::bad_input);
    EXPECT_FALSE(image.error().message.empty());
  }
  EXPECT_LT(opened, 8U) << "only what follows the pixels may be missing";
}

TEST(Gif, FlippedBitsGiveAnImageOrAnError) {
  const Bytes gif = encode_gif({true, 2, 0, 0});
  int refused = 0;
  for (size_t bit = 0; bit < 8 * gif.size(); ++bit) {
    Bytes damaged = gif;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ (1 << bit % 8));
    refused += decode_gif(damaged, {1 << 20, 1 << 14}).ok() ? 0 : 1;
  }
  EXPECT_GT(refused, 0);
}

/// Seeds of each kind: with rows in order or interlaced, opaque or not, beside the canvas' corner.
TEST(Gif, DamageOfTenSeedsNeverCrashes) {
  for (const bool interlaced : {false, true})
    for (const int transparent : {NO_TRANSPARENT_COLOR, 0, 7})
      for (const int left : {0, 2}) {
        const Bytes good = encode_gif({interlaced, transparent, left, 2 - left});
        ASSERT_TRUE(decode_gif(good).ok());
        survive_damage(good, 200, [](ByteView bytes) {
          return decode_gif(bytes, {1 << 20, 1 << 14});
        });
      }
}

TEST(Gif, HugeSizesAreRefusedBeforePixelsTakeMemory) {
  Bytes gif = encode_gif({});
  gif[7] = gif[9] = 0xff;
  EXPECT_EQ(decode_gif(gif).error().code, ErrorCode::limit);
  gif[7] = gif[9] = 0x20;
  EXPECT_EQ(decode_gif(gif).error().code, ErrorCode::bad_input);
}

}  // namespace
}  // namespace relievo

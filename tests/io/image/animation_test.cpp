#include "io/image/animation.h"

#include <gif_lib.h>
#include <gtest/gtest.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <array>

#include "io/image/decode_image.h"
#include "io/image/gif.h"
#include "io/image/png.h"
#include "io/image/webp.h"
#include "io/support/damage.h"

namespace relievo {
namespace {

constexpr int canvas_side = 8;

/// A square of 2 px at the left on a transparent canvas, or on a canvas of that colour.
struct Square {
  int left = 0;
  int disposal = DISPOSE_DO_NOT;
};

int append_gif(GifFileType* gif, const GifByteType* bytes, int count) {
  auto* out = static_cast<Bytes*>(gif->UserData);
  out->insert(out->end(), bytes, bytes + count);
  return count;
}

/// Each picture is a square of 2 px in the colour of its number.
Bytes animated_gif(const std::vector<Square>& squares) {
  Bytes bytes;
  int error = 0;
  GifFileType* gif = EGifOpen(&bytes, append_gif, &error);
  ColorMapObject* colors = GifMakeMapObject(8, nullptr);
  for (int k = 0; k < 8; ++k) colors->Colors[k] = {static_cast<uint8_t>(30 * k), 9, 7};
  EGifSetGifVersion(gif, true);
  EGifPutScreenDesc(gif, canvas_side, canvas_side, 8, 0, colors);
  for (size_t k = 0; k < squares.size(); ++k) {
    const GraphicsControlBlock control = {squares[k].disposal, false, 10, NO_TRANSPARENT_COLOR};
    std::array<GifByteType, 4> block = {};
    EGifGCBToExtension(&control, block.data());
    EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, 4, block.data());
    EGifPutImageDesc(gif, squares[k].left, 0, 2, 2, false, nullptr);
    std::array<GifPixelType, 2> line = {static_cast<uint8_t>(k + 1), static_cast<uint8_t>(k + 1)};
    for (int y = 0; y < 2; ++y) EGifPutLine(gif, line.data(), 2);
  }
  GifFreeMapObject(colors);
  EGifCloseFile(gif, &error);
  return bytes;
}

Image8 plain_picture(uint8_t red) {
  Image8 image(canvas_side, canvas_side, 4, 255);
  for (size_t i = 0; i < image.pixels.size(); i += 4) image.pixels[i] = red;
  return image;
}

Bytes animated_webp(const std::vector<Image8>& frames) {
  WebPAnimEncoderOptions options;
  WebPAnimEncoderOptionsInit(&options);
  WebPAnimEncoder* encoder = WebPAnimEncoderNew(canvas_side, canvas_side, &options);
  WebPConfig config;
  WebPConfigInit(&config);
  config.lossless = 1;
  int time = 0;
  for (const Image8& frame : frames) {
    WebPPicture picture;
    WebPPictureInit(&picture);
    picture.use_argb = 1;
    picture.width = picture.height = canvas_side;
    WebPPictureImportRGBA(&picture, frame.pixels.data(), 4 * canvas_side);
    WebPAnimEncoderAdd(encoder, &picture, time, &config);
    WebPPictureFree(&picture);
    time += 100;
  }
  WebPAnimEncoderAdd(encoder, nullptr, time, nullptr);
  WebPData data;
  WebPDataInit(&data);
  WebPAnimEncoderAssemble(encoder, &data);
  Bytes bytes(data.bytes, data.bytes + data.size);
  WebPDataClear(&data);
  WebPAnimEncoderDelete(encoder);
  return bytes;
}

TEST(Animation, GifFramesArePaintedOverEachOther) {
  const Bytes gif = animated_gif(
      {{0, DISPOSE_DO_NOT}, {2, DISPOSE_BACKGROUND}, {4, DISPOSE_PREVIOUS}, {6, DISPOSE_DO_NOT}});
  EXPECT_EQ(frame_count(gif), 4u);
  const auto frames = decode_frames(gif);
  ASSERT_TRUE(frames) << to_string(frames.error());
  ASSERT_EQ(frames->size(), 4u);
  const auto reds = [&](size_t k) {
    std::vector<int> found;
    for (int x = 0; x < canvas_side; x += 2)
      found.push_back((*frames)[k].at(x, 0, 3) == 0 ? -1 : (*frames)[k].at(x, 0, 0));
    return found;
  };
  EXPECT_EQ(reds(0), (std::vector<int>{30, -1, -1, -1}));
  EXPECT_EQ(reds(1), (std::vector<int>{30, 60, -1, -1}));
  EXPECT_EQ(reds(2), (std::vector<int>{30, -1, 90, -1}));
  EXPECT_EQ(reds(3), (std::vector<int>{30, -1, -1, 120}));
  EXPECT_EQ(decode_image(gif)->pixels, frames->front().pixels);
}

TEST(Animation, WebpFramesComeBack) {
  const std::vector<Image8> made = {plain_picture(10), plain_picture(90), plain_picture(200)};
  const Bytes webp = animated_webp(made);
  EXPECT_EQ(frame_count(webp), 3u);
  const auto frames = decode_frames(webp);
  ASSERT_TRUE(frames) << to_string(frames.error());
  ASSERT_EQ(frames->size(), 3u);
  for (size_t k = 0; k < made.size(); ++k) EXPECT_EQ((*frames)[k].pixels, made[k].pixels);
  EXPECT_EQ(decode_image(webp)->pixels, made[0].pixels);
}

TEST(Animation, OfSeveralFramesTheFirstIsNamed) {
  const Bytes gif = animated_gif({{0}, {2}});
  EXPECT_NE(first_frame_warning(gif).find("first of 2 frames"), std::string::npos);
  EXPECT_EQ(first_frame_warning(animated_gif({{0}})), "");
  const Error blank{ErrorCode::bad_input, "the drawing is blank", ""};
  EXPECT_NE(in_first_frame(blank, gif).message.find("first of 2 frames"), std::string::npos);
  EXPECT_EQ(in_first_frame(blank, animated_gif({{0}})).message, blank.message);
}

TEST(Animation, AnimatedPngFilesAreNamed) {
  Bytes png = *encode_png(plain_picture(10));
  const Bytes control = {0, 0, 0, 8, 'a', 'c', 'T', 'L', 0, 0, 0, 5, 0, 0, 0, 0, 1, 2, 3, 4};
  png.insert(png.begin() + 33, control.begin(), control.end());
  EXPECT_EQ(frame_count(png), 5u);
  EXPECT_NE(first_frame_warning(png).find("first of 5 frames"), std::string::npos);
  EXPECT_EQ(decode_frames(png).error().code, ErrorCode::bad_input);
}

TEST(Animation, PixelsOfAllFramesTogetherAreLimited) {
  const Bytes gif = animated_gif({{0}, {2}, {4}});
  EXPECT_TRUE(decode_frames(gif, {3 * canvas_side * canvas_side, 100}));
  const auto refused = decode_frames(gif, {3 * canvas_side * canvas_side - 1, 100});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::limit);
  EXPECT_NE(refused.error().message.find("3 frames"), std::string::npos);
}

TEST(Animation, DamageNeverCrashes) {
  const ImageLimits small = {1 << 20, 1 << 14};
  survive_damage(animated_gif({{0}, {2, DISPOSE_BACKGROUND}, {4, DISPOSE_PREVIOUS}}), 300,
                 [&](ByteView bytes) { return decode_gif_frames(bytes, small); });
  survive_damage(animated_webp({plain_picture(10), plain_picture(90)}), 300,
                 [&](ByteView bytes) { return decode_webp_frames(bytes, small); });
}

}  // namespace
}  // namespace relievo

#include "io/image/row_average.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "io/image/decode_image.h"
#include "io/image/png.h"
#include "io/support/encode_jpeg.h"
#include "kernel/image/enlarge.h"

namespace relievo {
namespace {

/// A grey picture of 7000 x 1200 px. Squares of two px a side have levels that grow to the right,
/// and differ by `contrast` from side to side.
Image8 ramp(int contrast) {
  Image8 image(7000, 1200, 1);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.at(x, y) = static_cast<uint8_t>(20 + x / 2 % 200 + (x % 2 == 0 ? 0 : 2 * contrast));
  return image;
}

TEST(ReductionFactor, LeavesTwoMegapixelsOrLittleMore) {
  EXPECT_EQ(reduction_factor(2828, 2828), 1);  // below 8 megapixels
  EXPECT_EQ(reduction_factor(4000, 2000), 2);
  EXPECT_EQ(reduction_factor(6900, 6900), 4);
  EXPECT_EQ(reduction_factor(10500, 10500), 7);
  for (int side = 2829; side < 15000; side += 7) {
    const int reduced = reduced_side(side, reduction_factor(side, side));
    EXPECT_GE(int64_t{reduced} * reduced, kept_pixels);
    EXPECT_LE(int64_t{reduced} * reduced, 9 * kept_pixels / 4 + 2 * reduced);
  }
}

TEST(RowAverage, ColoursCountByTheirAlpha) {
  Image8 image(3, 3, 4);
  const auto set = [&](int x, int y, std::array<uint8_t, 4> rgba) {
    std::copy(rgba.begin(), rgba.end(), &image.at(x, y));
  };
  set(0, 0, {200, 0, 40, 255});
  set(1, 0, {100, 0, 40, 255});
  set(0, 1, {9, 99, 199, 0});
  set(2, 0, {10, 20, 30, 100});
  set(2, 1, {20, 40, 50, 50});
  const Image8 reduced = averaged(image, 2);
  ASSERT_EQ(reduced.width, 2);
  ASSERT_EQ(reduced.height, 2);
  EXPECT_EQ(reduced.pixels, (std::vector<uint8_t>{150, 0, 40, 128, 13, 27, 37, 75,  //
                                                  0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(averaged(image, 1).pixels, image.pixels);
}

TEST(DecodeReduced, PngBecomesExactAverages) {
  const auto reduced = decode_fitted(*encode_png(ramp(3)));
  ASSERT_TRUE(reduced) << to_string(reduced.error());
  ASSERT_EQ(reduced->factor, 2);
  ASSERT_EQ(reduced->rgba.width, 3500);
  ASSERT_EQ(reduced->rgba.height, 600);
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 3500; ++x) {
      ASSERT_EQ(reduced->rgba.at(x, y, 1), 23 + x % 200) << x << ", " << y;
      ASSERT_EQ(reduced->rgba.at(x, y, 3), 255);
    }
}

TEST(DecodeReduced, JpegBecomesAveragesUpToItsPacking) {
  for (const bool progressive : {false, true}) {
    const auto reduced = decode_fitted(encode_jpeg(ramp(3), {JCS_GRAYSCALE, progressive, {}}));
    ASSERT_TRUE(reduced) << to_string(reduced.error());
    ASSERT_EQ(reduced->factor, 2);
    ASSERT_EQ(reduced->rgba.width, 3500);
    ASSERT_EQ(reduced->rgba.height, 600);
    for (int x = 0; x < 3500; ++x) {
      if (x % 200 > 3 && x % 200 < 196) {  // away from the steps
        ASSERT_NEAR(reduced->rgba.at(x, 99, 2), 23 + x % 200, 4) << x;
      }
    }
  }
}

TEST(DecodeReduced, JpegOfAnyFactorHasTheSizeOfItsSquares) {
  const Bytes file = encode_jpeg(Image8(50, 37, 1, 90), {JCS_GRAYSCALE, false, {}});
  for (int factor = 1; factor <= 12; ++factor) {
    const auto reduced = decode_jpeg(file, {}, factor);
    ASSERT_TRUE(reduced) << to_string(reduced.error());
    EXPECT_EQ(reduced->width, reduced_side(50, factor)) << factor;
    EXPECT_EQ(reduced->height, reduced_side(37, factor)) << factor;
    for (size_t i = 0; i < reduced->pixels.size(); ++i)
      ASSERT_EQ(reduced->pixels[i], i % 4 == 3 ? 255 : 90) << factor;
  }
}

TEST(DecodeReduced, PicturesOfUsualSizesStayAsTheyAre) {
  const Image8 image(small_side, 30, 4, 77);
  const auto whole = decode_fitted(*encode_png(image));
  ASSERT_TRUE(whole) << to_string(whole.error());
  EXPECT_EQ(whole->factor, 1);
  EXPECT_EQ(whole->times, 1);
  EXPECT_EQ(whole->rgba.pixels, image.pixels);
}

TEST(DecodeReduced, SmallPicturesAreEnlarged) {
  Image8 image(24, 30, 4, 255);
  for (size_t i = 0; i < image.pixels.size(); i += 4)
    image.pixels[i] = static_cast<uint8_t>(31 * i);
  const auto large = decode_fitted(*encode_png(image));
  ASSERT_TRUE(large) << to_string(large.error());
  EXPECT_EQ(large->factor, 1);
  EXPECT_EQ(large->times, 10);
  EXPECT_EQ(large->rgba.pixels, enlarged(image, 10).pixels);
  EXPECT_EQ(fitted(image).rgba.pixels, large->rgba.pixels);
}

TEST(DecodeReduced, OnlyWhatIsReadRowByRowMayExceedTheLimitOfWholePictures) {
  ImageLimits limits;
  limits.max_pixels = 4'000'000;
  const Image8 image = ramp(0);
  EXPECT_TRUE(decode_fitted(*encode_png(image), limits));
  EXPECT_TRUE(decode_fitted(encode_jpeg(image, {JCS_GRAYSCALE, false, {}}), limits));
  const Bytes progressive = encode_jpeg(image, {JCS_GRAYSCALE, true, {}});
  EXPECT_EQ(decode_fitted(progressive, limits).error().code, ErrorCode::limit);
  EXPECT_EQ(decode_image(*encode_png(image), limits).error().code, ErrorCode::limit);
  limits.max_streamed = 8'000'000;
  const auto refused = decode_fitted(*encode_png(image), limits);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("8 megapixels; make it smaller"), std::string::npos);
}

}  // namespace
}  // namespace relievo

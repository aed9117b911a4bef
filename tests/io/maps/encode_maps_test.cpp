#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "io/support/raw_png.h"
#include "relievo/maps.h"

namespace relievo {
namespace {

/// 3 x 1 pixels: background, part 0 looking up and to the right, part 2 looking down.
ReliefMaps sample_maps() {
  ReliefMaps maps;
  maps.height = ImageF(3, 1, 1, std::numeric_limits<float>::quiet_NaN());
  maps.height.pixels[1] = -7.5F;
  maps.height.pixels[2] = 12.25F;
  maps.normal = ImageF(3, 1, 3);
  maps.normal.pixels = {0, 0, 1, 0.6F, 0.64F, 0.48F, 0, -1, 0};
  maps.part = Image<int32_t>(3, 1, 1);
  maps.part.pixels = {-1, 0, 2};
  return maps;
}

TEST(NormalMap, GreenPointsUpOrDown) {
  const RawPng up = read_raw_png(*encode_normal_map(sample_maps()));
  EXPECT_EQ(up.bit_depth, 8);
  EXPECT_EQ(up.samples.pixels, (std::vector<uint16_t>{128, 128, 255, 204, 209, 189, 128, 0, 128}));
  const RawPng down = read_raw_png(*encode_normal_map(sample_maps(), true));
  EXPECT_EQ(down.samples.pixels,
            (std::vector<uint16_t>{128, 128, 255, 204, 46, 189, 128, 255, 128}));
}

TEST(DepthMap, HeightsComeBackFromTheTexts) {
  ReliefMaps maps = sample_maps();
  maps.height = ImageF(100, 1, 1, std::numeric_limits<float>::quiet_NaN());
  for (int x = 1; x < 100; ++x) maps.height.at(x, 0) = static_cast<float>(std::sin(x) * 40 + 3);
  const RawPng raw = read_raw_png(*encode_depth_map(maps));
  ASSERT_EQ(raw.bit_depth, 16);
  const double scale = std::stod(raw.texts.at("height_scale"));
  const double offset = std::stod(raw.texts.at("height_offset"));
  EXPECT_EQ(raw.samples.at(0, 0), 0);
  for (int x = 1; x < 100; ++x) {
    ASSERT_GE(raw.samples.at(x, 0), 1);
    ASSERT_NEAR(offset + scale * raw.samples.at(x, 0), maps.height.at(x, 0), 0.501 * scale);
  }
}

TEST(DepthMap, LowestIsOneAndHighestIsWhite) {
  const RawPng raw = read_raw_png(*encode_depth_map(sample_maps()));
  EXPECT_EQ(raw.samples.pixels, (std::vector<uint16_t>{0, 1, 65535}));
}

TEST(DepthMap, FlatReliefIsWhiteAndKeepsItsHeight) {
  ReliefMaps maps = sample_maps();
  maps.height.pixels[2] = maps.height.pixels[1];
  const RawPng raw = read_raw_png(*encode_depth_map(maps));
  EXPECT_EQ(raw.samples.pixels, (std::vector<uint16_t>{0, 65535, 65535}));
  EXPECT_EQ(std::stod(raw.texts.at("height_scale")), 0);
  EXPECT_EQ(std::stod(raw.texts.at("height_offset")), -7.5);
}

TEST(DepthMap, BackgroundAloneIsBlack) {
  ReliefMaps maps = sample_maps();
  maps.height = ImageF(2, 2, 1, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(read_raw_png(*encode_depth_map(maps)).samples.pixels, std::vector<uint16_t>(4, 0));
}

TEST(PartMap, CountsFromOne) {
  EXPECT_EQ(read_raw_png(*encode_part_map(sample_maps())).samples.pixels,
            (std::vector<uint16_t>{0, 1, 3}));
  ReliefMaps many = sample_maps();
  many.part.pixels[0] = 65535;
  EXPECT_EQ(encode_part_map(many).error().code, ErrorCode::limit);
}

}  // namespace
}  // namespace relievo

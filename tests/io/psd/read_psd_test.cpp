#include "io/psd/read_psd.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/psd/psd_bytes.h"

namespace relievo {
namespace {

const std::vector<uint8_t> red = {200, 20, 30, 255};
const std::vector<uint8_t> blue = {10, 40, 220, 255};

PsdLayerSpec layer(const std::string& name, int x, int y, const Image8& rgba) {
  PsdLayerSpec spec;
  spec.name = name;
  spec.x = x;
  spec.y = y;
  spec.rgba = rgba;
  return spec;
}

/// A red square below a blue one that reaches beyond the canvas.
PsdSpec two_squares() {
  PsdSpec spec;
  spec.width = spec.height = 40;
  spec.layers = {layer("body", 4, 4, filled(24, 24, red)),
                 layer("head", 20, 20, filled(40, 40, blue))};
  return spec;
}

std::vector<uint8_t> pixel(const Image8& rgba, int x, int y) {
  return {rgba.at(x, y, 0), rgba.at(x, y, 1), rgba.at(x, y, 2), rgba.at(x, y, 3)};
}

class ReadPsd : public testing::TestWithParam<std::tuple<PsdPacking, int>> {};

TEST_P(ReadPsd, FindsLayersInEveryPacking) {
  PsdSpec spec = two_squares();
  std::tie(spec.packing, spec.depth) = GetParam();
  for (int x = 0; x < 24; ++x) spec.layers[0].rgba.at(x, 0, 1) = static_cast<uint8_t>(9 * x);
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  ASSERT_FALSE(psd->flat);
  ASSERT_EQ(psd->marks.size(), 2U);
  EXPECT_EQ(psd->marks[0].name, "body");
  EXPECT_EQ(psd->marks[1].name, "head");
  const Image8& rgba = psd->picture.rgba;
  EXPECT_EQ(rgba.width, 40);
  EXPECT_EQ(pixel(rgba, 10, 10), red);
  EXPECT_EQ(pixel(rgba, 39, 39), blue);
  EXPECT_EQ(rgba.at(2, 2, 3), 0);
  for (int x = 0; x < 24; ++x) EXPECT_EQ(rgba.at(4 + x, 4, 1), 9 * x);
  EXPECT_TRUE(psd->warnings.empty());
}

INSTANTIATE_TEST_SUITE_P(Packings, ReadPsd,
                         testing::Combine(testing::Values(PsdPacking::raw, PsdPacking::pack_bits,
                                                          PsdPacking::zip,
                                                          PsdPacking::zip_differences),
                                          testing::Values(8, 16)));

TEST(ReadPsdLayers, GroupsHideDimAndMaskWhatTheyHold) {
  PsdSpec spec = two_squares();
  PsdLayerSpec end;
  end.divider = 3;
  PsdLayerSpec group;
  group.name = "group";
  group.divider = 1;
  group.opacity = 153;  // 0.6
  group.mask = filled(8, 40, {255});
  spec.layers.insert(spec.layers.begin(), end);
  spec.layers.insert(spec.layers.begin() + 2, group);
  auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_EQ(psd->picture.rgba.at(5, 10, 3), 153);
  EXPECT_EQ(psd->picture.rgba.at(9, 10, 3), 0);  // outside of the mask
  EXPECT_EQ(pixel(psd->picture.rgba, 30, 30), blue);
  spec.layers[2].hidden = true;
  psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  ASSERT_TRUE(psd->flat);  // one layer is left
  EXPECT_EQ(psd->picture.rgba.at(5, 10, 3), 0);
}

TEST(ReadPsdLayers, WhatIsClippedIsTextureOnItsBase) {
  PsdSpec spec = two_squares();
  spec.layers.insert(spec.layers.begin() + 1, layer("shade", 0, 0, filled(40, 40, {0, 0, 0, 255})));
  spec.layers[1].clipped = true;
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_EQ(psd->marks.size(), 2U);
  EXPECT_EQ(pixel(psd->picture.rgba, 10, 10), (std::vector<uint8_t>{0, 0, 0, 255}));
  EXPECT_EQ(psd->picture.rgba.at(2, 2, 3), 0);
  spec.layers[0].hidden = true;
  const auto without = read_psd(psd_bytes(spec));
  ASSERT_TRUE(without);
  ASSERT_TRUE(without->flat);
  EXPECT_EQ(without->picture.rgba.at(10, 10, 3), 0);
}

TEST(ReadPsdLayers, MasksCutAndSayWhatLiesOutside) {
  PsdSpec spec = two_squares();
  spec.layers[0].mask = filled(10, 10, {0});
  spec.layers[0].outside = 255;
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_EQ(psd->picture.rgba.at(6, 6, 3), 0);
  EXPECT_EQ(pixel(psd->picture.rgba, 16, 6), red);
}

TEST(ReadPsdLayers, WarnsOfWhatItPaintsOtherwise) {
  PsdSpec spec = two_squares();
  spec.layers[0].blend = "diss";
  spec.layers[1].effects = true;
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  ASSERT_EQ(psd->warnings.size(), 2U);
  EXPECT_NE(psd->warnings[0].find("\"body\""), std::string::npos);
  EXPECT_NE(psd->warnings[1].find("\"head\""), std::string::npos);
}

TEST(ReadPsdLayers, BlendsAsStated) {
  PsdSpec spec = two_squares();
  spec.layers[1].blend = "mul ";
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_EQ(psd->marks.size(), 2U);  // body, and ink that is no part
  EXPECT_TRUE(psd->marks[1].blends);
  EXPECT_EQ(pixel(psd->picture.rgba, 25, 25), (std::vector<uint8_t>{8, 3, 26, 255}));
  EXPECT_TRUE(psd->warnings.empty());
}

PsdLayerSpec divider(const std::string& name, int kind) {
  PsdLayerSpec spec;
  spec.name = name;
  spec.divider = kind;
  return spec;
}

TEST(ReadPsdLayers, WhatIsClippedToAGroupIsCutToAllOfIt) {
  PsdSpec spec = two_squares();
  PsdLayerSpec shade = layer("shade", 0, 0, filled(40, 40, {0, 0, 0, 255}));
  shade.clipped = true;
  PsdLayerSpec group = divider("both", 1);
  group.blend = "pass";
  spec.layers = {layer("floor", 0, 30, filled(10, 10, red)),
                 divider("", 3),
                 spec.layers[0],
                 spec.layers[1],
                 group,
                 shade};
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_EQ(psd->marks.size(), 3U);
  EXPECT_EQ(pixel(psd->picture.rgba, 10, 10), (std::vector<uint8_t>{0, 0, 0, 255}));
  EXPECT_EQ(pixel(psd->picture.rgba, 35, 35), (std::vector<uint8_t>{0, 0, 0, 255}));
  EXPECT_EQ(pixel(psd->picture.rgba, 5, 35), red);
  EXPECT_EQ(psd->picture.rgba.at(30, 5, 3), 0);
  EXPECT_TRUE(psd->warnings.empty());
}

TEST(ReadPsdLayers, RigTagsLeaveOutAndMerge) {
  PsdSpec spec = two_squares();
  spec.layers = {layer("[ignore] guide", 0, 0, filled(40, 40, blue)),
                 layer("body [slot]", 4, 4, filled(24, 24, red)),
                 divider("", 3),
                 layer("skull", 20, 20, filled(10, 10, blue)),
                 layer("jaw", 20, 30, filled(10, 8, red)),
                 divider("head [merge]", 1)};
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  ASSERT_EQ(psd->marks.size(), 2U);
  EXPECT_EQ(psd->marks[0].name, "body");
  EXPECT_EQ(psd->marks[1].name, "head");
  EXPECT_EQ(psd->picture.rgba.at(2, 2, 3), 0);
}

TEST(ReadPsdLayers, LeavesTheLayersToTheMergedPictureWhereTheyGiveNothing) {
  PsdSpec spec = two_squares();
  spec.merged = filled(40, 40, {255, 255, 255, 255});
  for (int y = 4; y < 28; ++y)
    for (int x = 4; x < 28; ++x) spec.merged.at(x, y, 0) = 30;
  spec.layers[0].blocks = spec.layers[1].blocks = {{"iOpa", {0, 0, 0, 0}}};
  spec.layers[0].effects = spec.layers[1].effects = true;
  auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_TRUE(psd->flat);
  EXPECT_EQ(psd->picture.rgba.at(10, 10, 0), 30);
  ASSERT_EQ(psd->warnings.size(), 1U);
  EXPECT_NE(psd->warnings[0].find("merged"), std::string::npos);
  spec.layers.resize(1);
  spec.layers[0].rgba = Image8();
  spec.layers[0].effects = false;
  psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_TRUE(psd->flat);
  EXPECT_EQ(psd->warnings.size(), 1U);
}

TEST(ReadPsdLayers, TakesTheMergedPictureOnlyWhereItLeavesSomethingOut) {
  PsdSpec spec = two_squares();
  spec.merged = filled(40, 40, {255, 255, 255, 255});
  spec.merged.at(3, 3, 0) = 0;
  auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_FALSE(psd->flat);
  spec.layers[0].effects = true;
  psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_TRUE(psd->flat);
}

TEST(ReadPsdLayers, SaysThatAnArtboardsGroundIsLeftOut) {
  PsdSpec spec = two_squares();
  spec.layers.insert(spec.layers.begin(), divider("", 3));
  spec.layers.push_back(divider("Artboard 1", 1));
  spec.layers.back().blocks = {{"artb", {0, 0, 0, 16}}};
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_EQ(psd->marks.size(), 2U);
  ASSERT_EQ(psd->warnings.size(), 1U);
  EXPECT_NE(psd->warnings[0].find("Artboard 1"), std::string::npos);
}

TEST(ReadPsdLayers, TakesWhiteOutOfAMergedPictureWithTransparency) {
  PsdSpec spec = two_squares();
  spec.merged_alpha = true;
  spec.merged = filled(40, 40, {255, 255, 255, 0});
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x) {
      spec.merged.at(x, y, 0) = 155;  // half of 55 on white
      spec.merged.at(x, y, 3) = 128;
    }
  spec.layers[0].hidden = spec.layers[1].hidden = true;
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_NEAR(psd->picture.rgba.at(5, 5, 0), 55, 1);
  EXPECT_EQ(psd->picture.rgba.at(5, 5, 3), 128);
  EXPECT_EQ(psd->picture.rgba.at(5, 30, 3), 0);
}

TEST(ReadPsdLayers, AFillIsPaintedInItsMask) {
  PsdSpec spec = two_squares();
  PsdLayerSpec fill = layer("patch", 6, 6, Image8());
  fill.mask = filled(8, 8, {255});
  Bytes color;
  for (const char* key : {"Rd  doub", "Grn doub", "Bl  doub"}) {
    const Bytes text = bytes_of(key);
    color.insert(color.end(), text.begin(), text.end());
    const Bytes ninety = {0x40, 0x56, 0x80, 0, 0, 0, 0, 0};  // 90.0
    color.insert(color.end(), ninety.begin(), ninety.end());
  }
  fill.blocks = {{"SoCo", color}};
  spec.layers.push_back(fill);
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_EQ(pixel(psd->picture.rgba, 8, 8), (std::vector<uint8_t>{90, 90, 90, 255}));
  EXPECT_EQ(pixel(psd->picture.rgba, 16, 16), red);
  EXPECT_TRUE(psd->warnings.empty());
}

TEST(ReadPsdLayers, TakesTheFlattenedPictureWhereThereAreNone) {
  PsdSpec spec;
  spec.packing = PsdPacking::pack_bits;
  spec.merged = filled(8, 8, red);
  const auto psd = read_psd(psd_bytes(spec));
  ASSERT_TRUE(psd) << psd.error().message;
  ASSERT_TRUE(psd->flat);
  EXPECT_EQ(pixel(psd->picture.rgba, 3, 3), red);
}

TEST(ReadPsdLayers, RefusesWithAReason) {
  const auto reason = [](const PsdSpec& spec) {
    const auto psd = read_psd(psd_bytes(spec));
    return psd ? "" : psd.error().message;
  };
  PsdSpec spec = two_squares();
  spec.mode = 4;
  EXPECT_NE(reason(spec).find("convert it to RGB"), std::string::npos);
  spec = two_squares();
  spec.version = 2;
  EXPECT_NE(reason(spec).find("PSB"), std::string::npos);
  spec = two_squares();
  spec.layers[0].hidden = spec.layers[1].hidden = true;
  EXPECT_NE(reason(spec).find("shows no layer"), std::string::npos);
  spec = two_squares();
  spec.width = 40000;
  EXPECT_NE(reason(spec).find("over the limit"), std::string::npos);
}

TEST(ReadPsdLayers, NothingIsSeenOnABaseWhoseSidesAreNegative) {
  PsdSpec spec = two_squares();
  spec.layers.push_back(layer("shade", 0, 0, filled(40, 40, {0, 0, 0, 255})));
  spec.layers[1].x = 9;
  spec.layers[1].y = 7;
  spec.layers[2].clipped = true;
  Bytes bytes = psd_bytes(spec);
  const Bytes corner = {0, 0, 0, 7, 0, 0, 0, 9};
  const auto box = std::search(bytes.begin(), bytes.end(), corner.begin(), corner.end());
  ASSERT_NE(box, bytes.end());
  box[15] = 3;  // the right side, left of the left one
  const Bytes alpha = {0xff, 0xff};
  const auto channel = std::search(box, bytes.end(), alpha.begin(), alpha.end());
  ASSERT_NE(channel, bytes.end());
  channel[0] = 0;  // no alpha: opaque all over
  channel[1] = 9;
  const auto psd = read_psd(bytes);
  ASSERT_TRUE(psd) << psd.error().message;
  EXPECT_EQ(pixel(psd->picture.rgba, 10, 10), red);
}

TEST(ReadPsdLayers, NeverReadsBeyondWhatIsThere) {
  for (const PsdPacking packing : {PsdPacking::raw, PsdPacking::pack_bits, PsdPacking::zip}) {
    PsdSpec spec = two_squares();
    spec.packing = packing;
    const Bytes whole = psd_bytes(spec);
    for (size_t size = 0; size < whole.size(); size += 7) {
      const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      const auto psd = read_psd(cut);
      // What follows the layers is not needed.
      EXPECT_TRUE(psd || !psd.error().message.empty());
    }
    for (size_t at = 0; at < std::min<size_t>(whole.size(), 600); ++at) {
      Bytes changed = whole;
      changed[at] ^= 0xff;
      const auto psd = read_psd(changed);
      EXPECT_TRUE(psd || !psd.error().message.empty());
    }
  }
}

}  // namespace
}  // namespace relievo

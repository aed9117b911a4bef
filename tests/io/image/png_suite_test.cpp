#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/image/decode_image.h"
#include "io/image/png.h"
#include "io/support/reference_png.h"
#include "relievo/files.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

class PngSuite : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(folder_)) GTEST_SKIP() << "the PNG suite is not at " << folder_;
    for (const auto& entry : fs::directory_iterator(folder_))
      if (entry.path().extension() == ".png") files_.push_back(entry.path());
    std::sort(files_.begin(), files_.end());
  }

  Result<Image8> decode(const std::string& name) const {
    return decode_png(*read_file(folder_ / (name + ".png")));
  }

  const fs::path folder_ = fs::path(RELIEVO_SHARED_DATA) / "adversarial/png/pngsuite";
  std::vector<fs::path> files_;
};

TEST_F(PngSuite, SoundFilesOpenAndDamagedOnesAreRefused) {
  EXPECT_GE(files_.size(), 175U);
  for (const fs::path& path : files_) {
    const bool damaged = path.filename().string()[0] == 'x';
    const Result<Image8> image = decode_png(*read_file(path));
    EXPECT_EQ(image.ok(), !damaged) << path;
    if (damaged && !image.ok()) {
      EXPECT_EQ(image.error().code, ErrorCode::bad_input);
      EXPECT_FALSE(image.error().message.empty());
    }
  }
}

TEST_F(PngSuite, EveryDamagedFileIsRefusedWithItsReason) {
  const std::map<std::string, std::string> reasons = {
      {"xs1n0g01", "byte 1 of its signature is wrong"},
      {"xs2n0g01", "byte 2 of its signature is wrong"},
      {"xs4n0g01", "byte 4 of its signature is wrong"},
      {"xs7n0g01", "byte 7 of its signature is wrong"},
      {"xcrn0g04", "the line ends in its signature were changed"},
      {"xlfn0g04", "the line ends in its signature were changed"},
      {"xhdn0g08", "the checksum of its header (IHDR) is wrong"},
      {"xc1n0g08", "there is no colour type 1"},
      {"xc9n2c08", "there is no colour type 9"},
      {"xd0n2c08", "colour type 2 has no bit depth of 0"},
      {"xd3n2c08", "colour type 2 has no bit depth of 3"},
      {"xd9n2c08", "colour type 2 has no bit depth of 99"},
      {"xdtn0g01", "it has no pixels (IDAT)"},
      {"xcsn0g01", "the checksum of its pixels (IDAT) is wrong"}};
  size_t refused = 0;
  for (const fs::path& path : files_) {
    if (path.filename().string()[0] != 'x') continue;
    ++refused;
    const auto reason = reasons.find(path.stem().string());
    ASSERT_NE(reason, reasons.end()) << path;
    const Result<Image8> image = decode_image(*read_file(path));
    ASSERT_FALSE(image.ok()) << path;
    EXPECT_NE(image.error().message.find(reason->second), std::string::npos)
        << path << ": " << image.error().message;
  }
  EXPECT_EQ(refused, reasons.size());
}

TEST_F(PngSuite, EverySoundFileHasItsGoldenPixels) {
  int compared = 0;
  for (const fs::path& path : files_) {
    if (path.filename().string()[0] == 'x') continue;
    const Bytes bytes = *read_file(path);
    const Result<Image8> image = decode_png(bytes);
    ASSERT_TRUE(image.ok()) << path;
    const Image8 golden = ReferencePng(bytes).image();
    ASSERT_EQ(image->width, golden.width);
    ASSERT_EQ(image->height, golden.height);
    EXPECT_EQ(image->pixels, golden.pixels) << path;
    ++compared;
  }
  EXPECT_GE(compared, 161);
}

/// Ten sound files, one for every colour type and then some of odd structure.
TEST_F(PngSuite, DamageNeverGoesUnnoticedOrCrashes) {
  for (const char* name : {"basn0g01", "basn0g16", "basn2c08", "basn3p02", "basn4a16", "basn6a08",
                           "basi3p08", "s05i3p02", "oi9n2c16", "tbbn2c16"}) {
    const Bytes good = *read_file(folder_ / (std::string(name) + ".png"));
    const Image8 golden = *decode_png(good);
    for (size_t size = 0; size < good.size(); size += 7)
      EXPECT_FALSE(decode_png(ByteView(good).first(size)).ok()) << name << " " << size;
    for (size_t bit = 0; bit < 8 * good.size(); bit += 11) {
      Bytes damaged = good;
      damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ (1 << bit % 8));
      const Result<Image8> image = decode_png(damaged, {1 << 20, 1 << 14});
      if (image.ok()) {
        EXPECT_EQ(image->width, golden.width) << name << " " << bit;
      }
    }
  }
}

TEST_F(PngSuite, InterlacingDoesNotChangeThePixels) {
  int compared = 0;
  for (const fs::path& path : files_) {
    std::string name = path.stem().string();
    if (name.rfind("basi", 0) != 0) continue;
    const Result<Image8> interlaced = decode(name);
    name[3] = 'n';
    const Result<Image8> plain = decode(name);
    ASSERT_TRUE(interlaced.ok() && plain.ok()) << name;
    EXPECT_EQ(interlaced->pixels, plain->pixels) << name;
    ++compared;
  }
  EXPECT_EQ(compared, 15);
}

TEST_F(PngSuite, ChunkingCompressionAndGammaDoNotChangeThePixels) {
  for (const auto& group :
       std::vector<std::vector<std::string>>{{"oi1n2c16", "oi2n2c16", "oi4n2c16", "oi9n2c16"},
                                             {"z00n2c08", "z03n2c08", "z06n2c08", "z09n2c08"},
                                             {"tbbn3p08", "tbgn3p08", "tbwn3p08", "tbyn3p08"}}) {
    const Result<Image8> first = decode(group[0]);
    ASSERT_TRUE(first.ok());
    for (const std::string& name : group) EXPECT_EQ(decode(name)->pixels, first->pixels) << name;
  }
}

TEST_F(PngSuite, TransparentColoursBecomeAlpha) {
  for (const char* name : {"tbbn0g04", "tbbn2c16", "tbbn3p08", "tm3n3p02"}) {
    const Result<Image8> image = decode(name);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->at(0, 0, 3), 0) << name;
  }
  const Result<Image8> opaque = decode("tp0n3p08");
  for (size_t i = 3; i < opaque->pixels.size(); i += 4) ASSERT_EQ(opaque->pixels[i], 255);
}

TEST_F(PngSuite, SamplesOfOneBitSpanBlackToWhite) {
  const Result<Image8> image = decode("basn0g01");
  ASSERT_TRUE(image.ok());
  for (size_t i = 0; i < image->pixels.size(); i += 4)
    ASSERT_TRUE(image->pixels[i] == 0 || image->pixels[i] == 255);
  EXPECT_EQ(image->at(0, 0), 255);
  EXPECT_EQ(image->at(31, 31), 0);
}

}  // namespace
}  // namespace relievo

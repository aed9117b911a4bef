#include "io/layered/read_ora.h"

#include <gtest/gtest.h>

#include "io/archive/archive.h"
#include "io/archive/zip_archive.h"
#include "io/image/png.h"
#include "io/layered/layer_support.h"
#include "io/support/damage.h"
#include "io/support/test_archive.h"

namespace relievo {
namespace {

using Names = std::vector<std::string>;
using Files = std::vector<std::pair<std::string, std::string>>;

std::string png(const Image8& image) { return to_text(*encode_png(image)); }

Files files_of(const std::string& stack) {
  return {{"mimetype", "image/openraster"},
          {"stack.xml", "<image w='300' h='300'><stack>" + stack + "</stack></image>"},
          {"data/body.png", png(disc(300, 300, {150, 180}, 90, red))},
          {"data/ear.png", png(disc(90, 90, {45, 45}, 40, blue))}};
}

Result<understanding::LayeredDrawing> read(const Files& files) {
  const auto entries = unpack_archive(test_archive(files));
  if (!entries) return entries.error();
  EXPECT_TRUE(is_ora(*entries));
  return read_ora(*entries);
}

TEST(ReadOra, TheFirstLayerLiesInFront) {
  auto ora =
      read(files_of("<layer name='ear' src='data/ear.png' x='105' y='35'/>"
                    "<layer name='body' src='data/body.png'/>"));
  ASSERT_TRUE(ora) << to_string(ora.error());
  EXPECT_EQ(part_names(*ora), (Names{"body", "ear"}));
  EXPECT_EQ(ora->scene.width, 300);
  const Box2 ear = bounding_box(ora->scene.parts[1].outline);
  EXPECT_NEAR(ear.min.x, 110, 0.1);
  EXPECT_NEAR(ear.min.y, 40, 0.1);
  EXPECT_TRUE(ora->warnings.empty());
}

TEST(ReadOra, HiddenAndFaintLayersAreNoParts) {
  const auto parts = [](const std::string& attribute) {
    auto ora = read(files_of("<stack " + attribute +
                             "><layer name='ear' src='data/ear.png' x='105' y='35'/></stack>"
                             "<layer name='body' src='data/body.png'/>"));
    return ora.ok() ? part_names(*ora) : Names();
  };
  EXPECT_EQ(parts(""), (Names{"body", "ear"}));
  EXPECT_EQ(parts("visibility='hidden'"), Names{"body"});
  EXPECT_EQ(parts("opacity='0.4'"), Names{"body"});
  EXPECT_EQ(parts("name='texture: decoration'"), Names{"body"});
  EXPECT_EQ(parts("name='part: both'"), Names{"both"});
}

TEST(ReadOra, UnknownBlendingIsPaintedPlainlyAndSaidSo) {
  const auto warnings = [](const std::string& blending) {
    const auto ora = read(files_of("<layer name='ear' src='data/ear.png' composite-op='" +
                                   blending + "'/><layer name='body' src='data/body.png'/>"));
    return ora.ok() ? ora->warnings : Names();
  };
  EXPECT_TRUE(warnings("svg:multiply").empty());
  ASSERT_EQ(warnings("krita:behind").size(), 1u);
  EXPECT_NE(warnings("krita:behind")[0].find("\"ear\""), std::string::npos);
}

TEST(ReadOra, AGroupKeepsItsBlendingToItselfUnlessItIsNotIsolated) {
  const auto alpha = [](const std::string& attributes) {
    const auto ora =
        read(files_of("<stack " + attributes +
                      "><layer src='data/ear.png' x='105' y='35' composite-op='svg:src-atop'/>"
                      "</stack><layer name='body' src='data/body.png'/>"));
    return ora.ok() ? ora->picture.rgba.at(150, 105, 2) : 0;
  };
  EXPECT_EQ(alpha(""), red[2]);  // atop of nothing
  EXPECT_EQ(alpha("isolation='isolate'"), red[2]);
  EXPECT_EQ(alpha("isolation='auto'"), blue[2]);
  EXPECT_EQ(alpha("isolation='auto' opacity='0.5'"), red[2]);
}

TEST(ReadOra, TheMergedPictureIsTakenWhereLayersShowNothing) {
  Files files = files_of(
      "<layer name='body' src='data/body.png' opacity='0.2'/>"
      "<layer name='ear' src='data/ear.png' opacity='0.1'/>");
  const auto faint = read(files);
  ASSERT_TRUE(faint);
  EXPECT_FALSE(faint->flat);
  files.emplace_back("mergedimage.png", png(disc(300, 300, {150, 180}, 90, red)));
  const auto merged = read(files);
  ASSERT_TRUE(merged);
  EXPECT_TRUE(merged->flat);
  EXPECT_EQ(merged->picture.rgba.at(150, 180, 3), 255);
  ASSERT_EQ(merged->warnings.size(), 1u);
  EXPECT_NE(merged->warnings[0].find("merged"), std::string::npos);
}

TEST(ReadOra, VectorLayersArePaintedOrNamed) {
  Files files = files_of(
      "<layer name='cap' src='data/cap.svg' x='105' y='35'/>"
      "<layer name='body' src='data/body.png'/>");
  files.emplace_back("data/cap.svg", "<svg/>");
  const auto entries = unpack_archive(test_archive(files));
  ASSERT_TRUE(entries);
  auto painted = read_ora(*entries, {}, [](const Bytes& svg) -> Result<Image8> {
    EXPECT_EQ(svg.size(), 6u);
    return disc(90, 90, {45, 45}, 40, blue);
  });
  ASSERT_TRUE(painted) << to_string(painted.error());
  EXPECT_EQ(part_names(*painted), (Names{"body", "cap"}));
  auto named = read_ora(*entries);
  ASSERT_TRUE(named);
  EXPECT_EQ(named->warnings.size(), 1u);
  files.emplace_back("mergedimage.png", png(disc(300, 300, {150, 180}, 90, red)));
  const auto with_picture = unpack_archive(test_archive(files));
  ASSERT_TRUE(with_picture);
  named = read_ora(*with_picture);
  ASSERT_TRUE(named);
  EXPECT_TRUE(named->flat);
}

TEST(ReadOra, RefusesWhatItCannotUse) {
  const auto message = [](const Files& files) {
    auto ora = read(files);
    if (!ora) return to_string(ora.error());
    const Status status = understanding::make_parts(*ora);
    EXPECT_FALSE(status);
    return status.ok() ? "" : to_string(status.error());
  };
  EXPECT_NE(message({{"mimetype", "image/openraster"}}).find("stack.xml"), std::string::npos);
  EXPECT_NE(message(files_of("<layer src='data/none.png'/>")).find("data/none.png"),
            std::string::npos);
  EXPECT_NE(message(files_of("<layer src='stack.xml'/>")).find("stack.xml"), std::string::npos);
  EXPECT_NE(message(files_of("")).find("opaque"), std::string::npos);
  Files broken = files_of("");
  broken[1].second = "<image w='300' h='300'><stack>";
  EXPECT_NE(message(broken).find("XML"), std::string::npos);
  Files huge = files_of("<layer src='data/body.png'/>");
  huge[1].second = "<image w='300000' h='300000'><stack/></image>";
  EXPECT_NE(message(huge).find("limit"), std::string::npos);
  std::string deep;
  for (int k = 0; k < 100; ++k) deep = "<stack>" + deep + "</stack>";
  EXPECT_NE(message(files_of(deep)).find("deeply"), std::string::npos);
}

TEST(Archive, RefusesWhatItShouldNotUnpack) {
  const auto code = [](const Bytes& bytes, const ArchiveLimits& limits = {}) {
    const auto entries = unpack_archive(bytes, limits);
    return entries.ok() ? std::string("ok") : to_string(entries.error());
  };
  EXPECT_EQ(code(test_archive({{"a", "text"}, {"b/c", "text"}})), "ok");
  EXPECT_NE(code(test_archive({{"../a", "text"}})).find("leads out"), std::string::npos);
  EXPECT_NE(code(test_archive({{"/a", "text"}})).find("leads out"), std::string::npos);
  EXPECT_NE(code(test_archive({{"a", "text"}}, true)).find("encrypted"), std::string::npos);
  EXPECT_NE(code(test_archive({{"a", std::string(1 << 22, 'a')}}), {2000, 1 << 20, 100000})
                .find("too large"),
            std::string::npos);
  EXPECT_NE(code(test_archive({{"a", std::string(1 << 22, 'a')}}), {2000, 1 << 30, 100})
                .find("too large"),
            std::string::npos);
  EXPECT_NE(code(test_archive({{"a", ""}, {"b", ""}, {"c", ""}}), {2}).find("too many"),
            std::string::npos);
}

/// Seeds with other pictures and stacks, damaged inside the archive, where no checksum protects
/// them.
TEST(ReadOra, DamageOfTenSeedsNeverCrashes) {
  for (int seed = 0; seed < 10; ++seed) {
    const int size = 20 + 3 * seed;
    const std::string picture = png(disc(size, size, {size / 2.0, size / 2.0}, size / 3.0, red));
    const std::string layer = "<layer name='n' src='data/a.png' x='" + std::to_string(seed) + "'/>";
    const auto entries =
        unpack_archive(test_archive({{"mimetype", "image/openraster"},
                                     {"stack.xml", "<image w='60' h='60'><stack opacity='0.9'>" +
                                                       layer + layer + "</stack></image>"},
                                     {"data/a.png", picture}}));
    ASSERT_TRUE(entries && read_ora(*entries).ok());
    for (size_t entry = 1; entry < entries->size(); ++entry)
      survive_damage((*entries)[entry].bytes, 150, [&](ByteView bytes) {
        std::vector<ArchiveEntry> damaged = *entries;
        damaged[entry].bytes = Bytes(bytes.begin(), bytes.end());
        return read_ora(damaged, {1 << 20, 1 << 14});
      });
  }
}

TEST(Archive, DamageIsFoundOrHarmless) {
  const Bytes whole = test_archive(files_of("<layer src='data/body.png'/>"));
  for (size_t length = 0; length < whole.size(); length += 37)
    EXPECT_FALSE(unpack_archive(ByteView(whole).subspan(0, length)));
  for (size_t at = 0; at < whole.size(); at += 11) {
    Bytes flipped = whole;
    flipped[at] ^= 0x10;
    const auto entries = unpack_archive(flipped);
    if (!entries) {
      EXPECT_FALSE(entries.error().message.empty());
    } else if (is_ora(*entries)) {
      const auto ora = read_ora(*entries);
      EXPECT_TRUE(ora.ok() || !ora.error().message.empty());
    }
  }
}

}  // namespace
}  // namespace relievo

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "io/archive/archive.h"
#include "io/archive/zip_archive.h"
#include "io/mesh/html_encode.h"
#include "io/mesh/usdz_encode.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

std::string text_of(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

size_t count_of(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// What stands between the brackets after a name.
std::string array_of(const std::string& usda, const std::string& name) {
  const size_t at = usda.find(name + " = [");
  if (at == std::string::npos) return "";
  const size_t from = at + name.size() + 4;
  return usda.substr(from, usda.find(']', from) - from);
}

TEST(Usdz, IsAnArchiveWhoseEntriesAreStoredAndAligned) {
  const Model model = hemisphere(40, 16);
  const Drawing drawing = quarters();
  const auto package = encode_usdz(model, &drawing);
  ASSERT_TRUE(package.ok()) << to_string(package.error());
  const auto entries = unpack_archive(*package);
  ASSERT_TRUE(entries.ok()) << to_string(entries.error());
  ASSERT_EQ(entries->size(), 2U);
  EXPECT_TRUE((*entries)[0].name.ends_with(".usda"));
  for (const ArchiveEntry& entry : *entries) {
    const auto at =
        std::search(package->begin(), package->end(), entry.bytes.begin(), entry.bytes.end());
    ASSERT_NE(at, package->end()) << entry.name;
    EXPECT_EQ((at - package->begin()) % 64, 0) << entry.name;
  }
}

TEST(Usdz, HasEveryVertexAndTriangle) {
  const Model model = hemisphere(40, 16);
  const auto package = encode_usdz(model, nullptr, 80);
  ASSERT_TRUE(package.ok());
  const auto entries = unpack_archive(*package);
  ASSERT_TRUE(entries.ok());
  ASSERT_EQ(entries->size(), 1U);
  const std::string usda = text_of((*entries)[0].bytes);
  EXPECT_EQ(count_of(array_of(usda, "point3f[] points"), "("), model.positions.size());
  EXPECT_EQ(count_of(array_of(usda, "normal3f[] normals"), "("), model.positions.size());
  EXPECT_EQ(count_of(array_of(usda, "texCoord2f[] primvars:st"), "("), model.positions.size());
  EXPECT_EQ(count_of(array_of(usda, "int[] faceVertexCounts"), "3"), model.triangles.size());
  EXPECT_EQ(count_of(array_of(usda, "int[] faceVertexIndices"), ","),
            3 * model.triangles.size() - 1);
  EXPECT_EQ(count_of(usda, "{"), count_of(usda, "}"));
  EXPECT_EQ(usda.find("drawing.png"), std::string::npos);
}

TEST(Html, NeedsNothingElse) {
  const Drawing drawing = quarters();
  const auto page = encode_html(hemisphere(40, 16), &drawing, "<b>&");
  ASSERT_TRUE(page.ok());
  const std::string text = text_of(*page);
  for (const char* outside : {"http:", "https:", "src=", "href=", "import"})
    EXPECT_EQ(text.find(outside), std::string::npos) << outside;
  EXPECT_NE(text.find("<title>&lt;b>&amp;</title>"), std::string::npos);
  EXPECT_NE(text.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
}

TEST(Html, PixelArtIsNotSmoothed) {
  Drawing drawing = quarters();
  const auto is_sharp = [&] {
    const std::string text = text_of(*encode_html(hemisphere(40, 16), &drawing, ""));
    return text.find("filter: \"NEAREST\"") != std::string::npos;
  };
  EXPECT_FALSE(is_sharp());
  drawing.pixel_art = 4;
  EXPECT_TRUE(is_sharp());
}

TEST(Html, HoldsAllVerticesAsBase64) {
  const Model model = hemisphere(40, 16);
  const auto page = encode_html(model, nullptr, "ball");
  ASSERT_TRUE(page.ok());
  const std::string text = text_of(*page);
  const auto length_after = [&text](const std::string& name) {
    const size_t from = text.find(name + ": \"") + name.size() + 3;
    return text.find('"', from) - from;
  };
  const auto in_base64 = [](size_t bytes) { return (bytes + 2) / 3 * 4; };
  EXPECT_EQ(length_after("vertices"), in_base64(32 * model.positions.size()));
  EXPECT_EQ(length_after("triangles"), in_base64(12 * model.triangles.size()));
  EXPECT_EQ(length_after("picture"), 0U);
}

TEST(Pages, AreRefusedWithoutTriangles) {
  EXPECT_FALSE(encode_usdz(empty_model(10, 10), nullptr).ok());
  EXPECT_FALSE(encode_html(empty_model(10, 10), nullptr, "").ok());
}

}  // namespace
}  // namespace relievo

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "io/archive/archive.h"
#include "io/archive/zip_archive.h"
#include "io/mesh/filament_colours.h"
#include "io/mesh/threemf_encode.h"
#include "relief/finish/model_texture.h"
#include "solid/solid_case.h"
#include "support/random_scene.h"
#include "support/sample_models.h"
#include "support/threemf_checks.h"

namespace relievo {
namespace {

using namespace testing;

Solid painted_ball() {
  auto solid = make_solid({hemisphere(40, 32), {}, {}}, quarters(), {});
  EXPECT_TRUE(solid.ok());
  return std::move(*solid);
}

std::string model_text(const Bytes& package) {
  const auto entries = unpack_archive(package);
  EXPECT_TRUE(entries.ok());
  const ArchiveEntry* entry = find_entry(*entries, "3D/3dmodel.model");
  return entry == nullptr ? "" : std::string(entry->bytes.begin(), entry->bytes.end());
}

/// How often each value of an attribute occurs.
std::map<std::string, int> values(const std::string& text, const std::string& attribute) {
  std::map<std::string, int> counts;
  const std::string begin = attribute + "=\"";
  for (size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    at += begin.size();
    ++counts[text.substr(at, text.find('"', at) - at)];
  }
  return counts;
}

TEST(Threemf, IsReadByTheReferenceLibraryWithoutWarnings) {
  const Solid solid = painted_ball();
  for (const Drawing* drawing : {static_cast<const Drawing*>(nullptr), &solid.drawing}) {
    const auto package = encode_3mf(solid.model, drawing);
    ASSERT_TRUE(package.ok()) << to_string(package.error());
    const ThreemfCensus census = census_of_3mf(*package);
    EXPECT_TRUE(census.readable);
    EXPECT_EQ(census.warnings, std::vector<std::string>());
    EXPECT_EQ(census.objects, 1);
    EXPECT_EQ(census.triangles, static_cast<int>(solid.model.triangles.size()));
    EXPECT_TRUE(census.manifold);
  }
}

TEST(Threemf, HoldsRandomSolidsAsManifolds) {
  for (uint64_t seed = 0; seed < 10; ++seed) {
    const auto solid = make_solid(sheet_of(random_scene(seed), 1500), {}, {});
    ASSERT_TRUE(solid.ok());
    const auto package = encode_3mf(solid->model, nullptr, {.size_mm = 77});
    ASSERT_TRUE(package.ok());
    const ThreemfCensus census = census_of_3mf(*package);
    EXPECT_TRUE(census.manifold) << seed;
    EXPECT_EQ(census.triangles, static_cast<int>(solid->model.triangles.size()));
  }
}

TEST(Threemf, PaintsEveryTriangleForBothKindsOfSlicers) {
  const Solid solid = painted_ball();
  const auto package = encode_3mf(solid.model, &solid.drawing, {.filaments = 5});
  const auto other =
      encode_3mf(solid.model, &solid.drawing, {.filaments = 5, .slicer = Slicer::bambu});
  ASSERT_TRUE(package.ok() && other.ok());
  const std::string text = model_text(*package);
  const std::map<std::string, int> paint = values(text, "slic3rpe:mmu_segmentation");
  EXPECT_EQ(values(model_text(*other), "paint_color"), paint);
  // White, red, green, blue and the base.
  ASSERT_EQ(paint.size(), 5U);
  int all = 0;
  for (const char* code : {"4", "8", "0C", "1C", "2C"}) {
    ASSERT_EQ(paint.count(code), 1U) << code;
    all += paint.at(code);
  }
  EXPECT_EQ(all, static_cast<int>(solid.model.triangles.size()));
  for (const char* colour : {"#FF0000", "#00FF00", "#0000FF"})
    EXPECT_NE(text.find(colour), std::string::npos) << colour;
}

TEST(Threemf, IsTheSameEveryTime) {
  const Solid solid = painted_ball();
  const auto first = encode_3mf(solid.model, &solid.drawing);
  const auto second = encode_3mf(solid.model, &solid.drawing);
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_TRUE(*first == *second);
}

TEST(FilamentColours, ComeByAreaAndAreNotMoreThanThereAre) {
  const Model model = hemisphere(40, 32);
  const Image8 texture = relief::model_texture(model, quarters());
  const FilamentColours all = reduce_colours(model, texture, 16);
  EXPECT_EQ(all.colours.size(), 4U);
  std::vector<double> areas(all.colours.size());
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const auto& [a, b, c] = model.triangles[t];
    areas[all.triangle[t]] += norm(
        cross(model.positions[b] - model.positions[a], model.positions[c] - model.positions[a]));
  }
  for (size_t k = 1; k < areas.size(); ++k) EXPECT_GE(areas[k - 1], areas[k] - 1e-6);
  EXPECT_EQ(reduce_colours(model, texture, 1).colours.size(), 1U);
  EXPECT_EQ(reduce_colours(model, texture, 2).colours.size(), 2U);
}

}  // namespace
}  // namespace relievo

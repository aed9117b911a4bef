#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/mesh/placement.h"
#include "io/support/temporary_folder.h"
#include "samples/drawing_relief.h"
#include "solid/solid_case.h"
#include "support/solid_checks.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using namespace testing;

void expect_sound(const std::string& path, const SolidOptions& options) {
  SCOPED_TRACE(path);
  relief::ReliefOptions relief_options;
  relief_options.hidden = options.back != BackSide::flat;
  const DrawnRelief drawn = relief_of(path, relief_options);
  const auto solid = make_solid(sheet_of(drawn.scene, drawn.relief), drawn.drawing, options);
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  const std::string stl = stl_of(solid->model);
  const SolidCensus census = census_of_stl(stl);
  EXPECT_EQ(what_is_wrong(census), "");
  EXPECT_EQ(census.pieces, 1);
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "solid.stl").string();
  std::ofstream(file, std::ios::binary) << stl;
  EXPECT_EQ(admesh_complaints(file), "");
}

SolidOptions on(BaseShape base) {
  SolidOptions options;
  options.base = base;
  return options;
}

TEST(SolidSamples, AreClosed) {
  const std::vector<std::string> paths = drawings_in(RELIEVO_EXAMPLES);
  ASSERT_GE(paths.size(), 7U);
  for (const std::string& path : paths) expect_sound(path, on(BaseShape::none));
}

SolidOptions as_figure() {
  SolidOptions options;
  options.back = BackSide::mirror;
  return options;
}

TEST(SolidSurvey, SamplesAreClosedFigures) {
  for (const std::string& path : drawings_in(RELIEVO_EXAMPLES)) expect_sound(path, as_figure());
}

TEST(SolidSamples, AreClosedOnPlates) {
  const std::string wolf = std::string(RELIEVO_EXAMPLES) + "/wolf.svg";
  for (const BaseShape base : {BaseShape::outline, BaseShape::plate, BaseShape::round})
    expect_sound(wolf, on(base));
}

TEST(SolidSamples, FiguresOnABaseHaveTheirSize) {
  for (const char* name : {"/wolf.svg", "/griffin.svg"}) {
    relief::ReliefOptions relief_options;
    relief_options.hidden = true;
    const DrawnRelief drawn = relief_of(std::string(RELIEVO_EXAMPLES) + name, relief_options);
    for (const BaseShape base : {BaseShape::plate, BaseShape::round}) {
      SolidOptions options = as_figure();
      options.base = base;
      options.size = 80;
      const auto solid = make_solid(sheet_of(drawn.scene, drawn.relief), drawn.drawing, options);
      ASSERT_TRUE(solid.ok()) << to_string(solid.error());
      EXPECT_NEAR(longest_side(solid->model), 80, 0.1) << name;
    }
  }
}

TEST(SolidSurvey, OfLayeredDrawingsAreClosed) {
  const std::vector<std::string> paths = drawings_in(RELIEVO_SHARED_DATA "/layered");
  if (paths.empty()) GTEST_SKIP() << "no drawings in " RELIEVO_SHARED_DATA "/layered";
  for (const std::string& path : paths) {
    expect_sound(path, on(BaseShape::none));
    expect_sound(path, as_figure());
  }
}

}  // namespace
}  // namespace relievo

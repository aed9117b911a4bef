#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/solid_of.h"
#include "io/support/temporary_folder.h"
#include "relievo/read.h"
#include "solid/solid_case.h"
#include "support/random_scene.h"
#include "support/solid_checks.h"

namespace relievo {
namespace {

using namespace testing;

constexpr int survey_scenes = 1000;

/// What became of all solids of one kind.
struct Tally {
  std::string kind;
  SolidOptions options;
  int made = 0;
  int open = 0;      ///< an edge without two triangles
  int crossing = 0;  ///< triangles that cross
  int empty = 0;     ///< no volume
  int parted = 0;    ///< not as many pieces as are told, or not one on a plate
  int single = 0;    ///< one piece
  int most_triangles = 0;

  void add(const Solid& solid) {
    const SolidCensus found = census_of_stl(stl_of(solid.model));
    const bool plate = options.base == BaseShape::plate && options.back == BackSide::flat;
    ++made;
    open += found.uneven > 0 || !found.manifold ? 1 : 0;
    crossing += found.self_intersections > 0 ? 1 : 0;
    empty += found.volume > 0 ? 0 : 1;
    parted += found.pieces != solid.facts.pieces || (plate && found.pieces != 1) ? 1 : 0;
    single += found.pieces == 1 ? 1 : 0;
    most_triangles = std::max(most_triangles, found.triangles);
  }
};

std::vector<Tally> kinds() {
  std::vector<Tally> kinds(4);
  kinds[0].kind = "solid";
  kinds[1].kind = "solid on a plate";
  kinds[1].options.base = BaseShape::plate;
  kinds[2].kind = "figure";
  kinds[2].options.back = BackSide::mirror;
  kinds[3].kind = "figure on a disc";
  kinds[3].options.back = BackSide::mirror;
  kinds[3].options.base = BaseShape::round;
  return kinds;
}

TEST(SolidSurvey, RandomScenesAreClosedAndWhole) {
  std::vector<Tally> tallies = kinds();
  int refused = 0;
  for (int seed = 0; seed < survey_scenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // Other scenes than those of the quick tests.
    const Scene scene = random_scene(uint64_t{100000} + static_cast<uint64_t>(seed));
    const auto relief = relief_of(scene, 1500, true);
    if (!relief && relief.error().code == ErrorCode::bad_input) {
      ++refused;  // joins that cross at their ends
      continue;
    }
    ASSERT_TRUE(relief.ok()) << to_string(relief.error());
    const relief::VisibleSheet sheet = sheet_of(scene, *relief);
    for (Tally& tally : tallies) {
      const auto solid = make_solid(sheet, {}, tally.options);
      ASSERT_TRUE(solid.ok()) << tally.kind << ": " << to_string(solid.error());
      tally.add(*solid);
    }
  }
  EXPECT_LE(refused, survey_scenes / 100);
  std::cout
      << "| of random scenes | made | open | crossing | without volume | parted | of one piece | "
         "triangles at most |\n|---|---|---|---|---|---|---|---|\n";
  for (const Tally& t : tallies) {
    std::cout << "| " << t.kind << " | " << t.made << " | " << t.open << " | " << t.crossing
              << " | " << t.empty << " | " << t.parted << " | " << t.single << " | "
              << t.most_triangles << " |\n";
    EXPECT_EQ(t.made + refused, survey_scenes);
    EXPECT_EQ(t.open + t.crossing + t.empty + t.parted, 0) << t.kind;
  }
}

/// Pictures without layers, by name; a drawing's folder holds it beside other files.
std::vector<std::string> flat_drawings() {
  std::vector<std::string> paths;
  const std::filesystem::path folder = RELIEVO_SHARED_DATA "/flat";
  if (!std::filesystem::exists(folder)) return paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path texture = entry.path() / "texture.png";
    paths.push_back((std::filesystem::exists(texture) ? texture : entry.path()).string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

void expect_closed(const Solid& solid) {
  const std::string stl = stl_of(solid.model);
  const SolidCensus census = census_of_stl(stl);
  EXPECT_EQ(what_is_wrong(census), "");
  EXPECT_EQ(census.pieces, solid.facts.pieces);
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "solid.stl").string();
  std::ofstream(file, std::ios::binary) << stl;
  EXPECT_EQ(admesh_complaints(file), "");
}

/// The figure with the first of its limbs that can be mirrored.
std::optional<Solid> mirrored(const relief::Relief& relief, const DrawnScene& drawn,
                              SolidOptions options) {
  for (const Join& join : drawn.scene.joins) {
    options.mirror = {drawn.scene.parts[join.upper].id};
    auto solid = solid_of(relief, drawn.scene, drawn.drawing, options);
    if (solid) return std::move(*solid);
    EXPECT_EQ(solid.error().code, ErrorCode::usage) << to_string(solid.error());
  }
  return std::nullopt;
}

TEST(SolidSurvey, DrawingsAreClosedAndTheirMirroredLimbs) {
  std::vector<std::string> paths = drawings_in(RELIEVO_EXAMPLES);
  for (const auto& more : {drawings_in(RELIEVO_SHARED_DATA "/layered"), flat_drawings()})
    paths.insert(paths.end(), more.begin(), more.end());
  int limbs = 0;
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    const auto drawn = read_drawing(path);
    ASSERT_TRUE(drawn.ok()) << to_string(drawn.error());
    relief::ReliefOptions options;
    options.hidden = true;
    const auto relief = relief::build_relief(drawn->scene, options);
    ASSERT_TRUE(relief.ok()) << to_string(relief.error());
    SolidOptions figure;
    figure.back = BackSide::mirror;
    for (const SolidOptions& kind : {SolidOptions(), figure}) {
      const auto solid = solid_of(*relief, drawn->scene, drawn->drawing, kind);
      ASSERT_TRUE(solid.ok()) << to_string(solid.error());
      expect_closed(*solid);
    }
    const auto doubled = mirrored(*relief, *drawn, figure);
    if (doubled) expect_closed(*doubled);
    limbs += doubled ? 1 : 0;
  }
  std::cout << paths.size() << " drawings, a limb mirrored of " << limbs << "\n";
  EXPECT_GE(limbs, 6);  // the samples'
}

}  // namespace
}  // namespace relievo

#include "solid/make_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh/placement.h"
#include "solid/solid_case.h"
#include "support/random_scene.h"
#include "support/sample_models.h"
#include "support/solid_checks.h"

namespace relievo {
namespace {

using namespace testing;

/// A hemisphere of radius 40 px as a sheet.
relief::VisibleSheet ball() { return {hemisphere(40, 64), {}, {}}; }

SolidCensus census(const Solid& solid) { return census_of_stl(stl_of(solid.model)); }

TEST(MakeSolid, HasTheVolumeOfAHemisphereOnItsDisc) {
  SolidOptions options;
  options.size = 80;
  options.thickness = 3;
  const auto solid = make_solid(ball(), {}, options);
  ASSERT_TRUE(solid.ok());
  const double disc = std::numbers::pi * 40 * 40;
  EXPECT_NEAR(solid->facts.volume, disc * (2.0 / 3 * 40 + 3), 1e-3 * disc * 30);
  EXPECT_EQ(what_is_wrong(census(*solid)), "");
  EXPECT_NEAR(census(*solid).volume, solid->facts.volume, 1e-6 * solid->facts.volume);
}

TEST(MakeSolid, ThePlateAddsItsOwnVolume) {
  SolidOptions options;
  options.size = 100;
  options.margin = 10;
  options.thickness = 3;
  options.corner = 5;
  const double r = 40;
  const double disc = std::numbers::pi * r * r;
  const double ball_volume = disc * 2 / 3 * r;
  const double corners = (4 - std::numbers::pi) * 5 * 5;
  const std::map<BaseShape, double> areas = {{BaseShape::outline, std::numbers::pi * 50 * 50},
                                             {BaseShape::round, std::numbers::pi * 50 * 50},
                                             {BaseShape::plate, 100 * 100 - corners}};
  for (const auto& [base, area] : areas) {
    options.base = base;
    const auto solid = make_solid(ball(), {}, options);
    ASSERT_TRUE(solid.ok()) << to_string(solid.error());
    const SolidCensus found = census(*solid);
    EXPECT_EQ(what_is_wrong(found), "");
    EXPECT_EQ(found.pieces, 1);
    EXPECT_EQ(found.holes, 0);
    EXPECT_NEAR(found.volume, ball_volume + 3 * area, 1e-3 * ball_volume);
    EXPECT_NEAR(longest_side(solid->model), 100, 0.1);
  }
}

TEST(MakeSolid, LimitsTheHeightAndTurnsNormalsWithIt) {
  SolidOptions options;
  options.size = 80;
  options.thickness = 1;
  options.height = 11;
  const auto solid = make_solid(ball(), {}, options);
  ASSERT_TRUE(solid.ok());
  const Model& model = solid->model;
  const Box3 box = extent(model);
  EXPECT_NEAR(box.max.z, 11, 1e-4);
  EXPECT_NEAR(box.max.x, 80, 1e-4);
  EXPECT_EQ(what_is_wrong(census(*solid)), "");
  // The ellipsoid (x / 40)^2 + (y / 40)^2 + (z / 10)^2 = 1 around (40, 40, 1).
  int checked = 0;
  for (size_t v = 0; v < model.positions.size(); ++v) {
    const Point3 p = model.positions[v] - Point3{40, 40, 1};
    if (p.z < 1 || model.normals[v].z < 0.1) continue;
    const Point3 expected = normalized({p.x / 1600, p.y / 1600, p.z / 100});
    EXPECT_LT(norm(model.normals[v] - expected), 1e-3);
    ++checked;
  }
  EXPECT_GT(checked, 1000);
  options.height = 400;
  const auto high = make_solid(ball(), {}, options);
  ASSERT_TRUE(high.ok());
  EXPECT_NEAR(extent(high->model).max.z, 41, 1e-4);
}

TEST(MakeSolid, HangsByAHoleOrARing) {
  SolidOptions options;
  options.base = BaseShape::plate;
  options.margin = 12;
  const auto plain = make_solid(ball(), {}, options);
  ASSERT_TRUE(plain.ok());
  options.hole = 5;
  const auto drilled = make_solid(ball(), {}, options);
  ASSERT_TRUE(drilled.ok());
  EXPECT_EQ(what_is_wrong(census(*drilled)), "");
  EXPECT_EQ(census(*drilled).holes, 1);
  EXPECT_NEAR(plain->facts.volume - drilled->facts.volume,
              options.thickness * std::numbers::pi * 2.5 * 2.5, 0.5);
  options.ring = 4;
  const auto both = make_solid(ball(), {}, options);
  ASSERT_TRUE(both.ok());
  EXPECT_EQ(census(*both).holes, 2);
  EXPECT_EQ(census(*both).pieces, 1);
}

TEST(MakeSolid, CutsWithAWallAroundItsPlate) {
  SolidOptions options;
  options.size = 100;
  options.base = BaseShape::outline;
  const auto plain = make_solid(ball(), {}, options);
  ASSERT_TRUE(plain.ok());
  options.cutter = 60;
  const auto cutter = make_solid(ball(), {}, options);
  ASSERT_TRUE(cutter.ok()) << to_string(cutter.error());
  const SolidCensus found = census(*cutter);
  EXPECT_EQ(what_is_wrong(found), "");
  EXPECT_EQ(found.pieces, 1);
  EXPECT_EQ(found.holes, 0);
  EXPECT_NEAR(extent(cutter->model).max.z, options.thickness + options.cutter, 1e-4);
  EXPECT_NEAR(longest_side(cutter->model), 100, 0.1);
  // Half an ellipsoid of 92.4 mm, half as high as the wall, its plate and a tube of 0.8 mm around
  // it.
  const double r = 0.5 * (100 - 2 * (3 + 0.8));
  const auto disc = [](double radius) { return std::numbers::pi * radius * radius; };
  const double volume = disc(r) * 2 / 3 * (0.5 * options.cutter) + disc(50) * options.thickness +
                        (disc(50) - disc(50 - 0.8)) * options.cutter;
  EXPECT_NEAR(found.volume, volume, 2e-3 * volume);
  options.hole = 3;
  EXPECT_FALSE(make_solid(ball(), {}, options).ok());
  options.hole = 0;
  options.base = BaseShape::plate;
  EXPECT_FALSE(make_solid(ball(), {}, options).ok());
}

TEST(MakeSolid, RefusesWhatHasNoRoom) {
  SolidOptions options;
  options.size = 5;
  options.base = BaseShape::plate;
  const auto small = make_solid(ball(), {}, options);
  ASSERT_FALSE(small.ok());
  EXPECT_EQ(small.error().code, ErrorCode::usage);
  options.size = 100;
  options.base = BaseShape::outline;
  options.hole = 8;
  const auto drilled = make_solid(ball(), {}, options);
  ASSERT_FALSE(drilled.ok());
  EXPECT_EQ(drilled.error().where, "--hole");
}

TEST(MakeSolid, NamesALengthThatIsOutOfItsRange) {
  for (const auto& [name, length, least, most, text] : solid_lengths) {
    SCOPED_TRACE(name);
    for (const double value : {least - 0.01, 1.01 * most, std::nan("")}) {
      SolidOptions options;
      options.*length = value;
      const auto solid = make_solid(ball(), {}, options);
      ASSERT_FALSE(solid.ok());
      EXPECT_EQ(solid.error().code, ErrorCode::usage);
      EXPECT_EQ(solid.error().where, name);
    }
    EXPECT_TRUE(SolidOptions().*length == 0 || SolidOptions().*length >= least);
  }
}

TEST(MakeSolid, NamesWhatIsLoose) {
  Model model = empty_model(300, 100);
  add_ellipsoid(model, {"large", {60, 50}, 0, {40, 40, 40}});
  add_ellipsoid(model, {"small", {200, 50}, 0, {20, 20, 20}});
  const auto solid = make_solid({model, {}, {}}, {}, {});
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  EXPECT_EQ(solid->facts.pieces, 2);
  EXPECT_EQ(solid->facts.loose, std::vector<std::string>{"small"});
  SolidOptions options;
  options.base = BaseShape::plate;
  const auto held = make_solid({model, {}, {}}, {}, options);
  ASSERT_TRUE(held.ok());
  EXPECT_EQ(held->facts.pieces, 1);
  EXPECT_TRUE(held->facts.loose.empty());
}

TEST(MakeSolid, PaintsTheBaseAndKeepsTheDrawing) {
  const auto solid = make_solid(ball(), quarters(), {});
  ASSERT_TRUE(solid.ok());
  const Image8& picture = solid->drawing.rgba;
  const Model& model = solid->model;
  const Image8 original = quarters().rgba;
  for (int y = 0; y < original.height; ++y)
    for (int x = 0; x < original.width; ++x)
      for (int c = 0; c < 4; ++c) EXPECT_EQ(picture.at(x, y, c), original.at(x, y, c));
  const ModelPart& base = model.parts.back();
  const double seam = static_cast<double>(original.height) / picture.height;
  for (int t = 0; t < static_cast<int>(model.triangles.size()); ++t) {
    const bool of_base = t >= base.first_triangle;
    for (const int v : model.triangles[t]) EXPECT_EQ(model.uvs[v].y > seam + 1e-9, of_base);
  }
}

/// Heights over every place of a model's vertices.
std::map<std::pair<double, double>, std::vector<double>> columns(const Model& model) {
  std::map<std::pair<double, double>, std::vector<double>> heights;
  for (const Point3 p : model.positions) heights[{p.x, p.y}].push_back(p.z);
  return heights;
}

class RandomSolid : public ::testing::TestWithParam<int> {};

TEST_P(RandomSolid, IsClosedAndShowsTheRelief) {
  const Scene scene = random_scene(static_cast<uint64_t>(GetParam()));
  const relief::VisibleSheet sheet = sheet_of(scene, 1500);
  SolidOptions options;
  options.size = 128;
  options.base = static_cast<BaseShape>(GetParam() % 4);
  options.ring = options.base != BaseShape::none && GetParam() % 3 == 0 ? 4 : 0;
  const auto solid = make_solid(sheet, {}, options);
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  const SolidCensus found = census(*solid);
  EXPECT_EQ(what_is_wrong(found), "");
  EXPECT_EQ(found.pieces, solid->facts.pieces);
  EXPECT_NEAR(found.volume, solid->facts.volume, 1e-5 * found.volume);
  if (options.base == BaseShape::plate || options.base == BaseShape::round) {
    EXPECT_EQ(found.pieces, 1);
  }

  // The vertices of the relief are there as they are, but for the few that had to rise.
  if (options.base != BaseShape::none) return;
  const Box3 box = extent(sheet.model);
  const Point3 sides = box.max - box.min;
  const double scale = std::min(options.size / std::max(sides.x, sides.y),
                                (options.size - options.thickness) / sides.z);
  const auto heights = columns(solid->model);
  int missing = 0;
  for (const std::array<int, 3>& t : sheet.model.triangles)
    for (const int v : t) {
      const Point3 p = scale * (sheet.model.positions[v] - box.min);
      const double unit = std::ldexp(1.0, 8 - 24);
      const auto column =
          heights.find({unit * std::round(p.x / unit), unit * std::round(p.y / unit)});
      const double z = p.z + options.thickness;
      const bool there = column != heights.end() &&
                         std::any_of(column->second.begin(), column->second.end(),
                                     [&](double found_z) { return std::abs(found_z - z) <= unit; });
      missing += there ? 0 : 1;
    }
  EXPECT_LE(missing, 6 + static_cast<int>(sheet.model.triangles.size()) / 500);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RandomSolid, ::testing::Range(0, 20));
INSTANTIATE_TEST_SUITE_P(SolidSurvey, RandomSolid, ::testing::Range(20, 100));

}  // namespace
}  // namespace relievo

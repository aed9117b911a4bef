#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "io/mesh/placement.h"
#include "solid/make_solid.h"
#include "solid/solid_case.h"
#include "support/random_scene.h"
#include "support/sample_models.h"
#include "support/solid_checks.h"

namespace relievo {
namespace {

using namespace testing;

SolidOptions figure_of(double size, BackSide back = BackSide::mirror) {
  SolidOptions options;
  options.size = size;
  options.back = back;
  return options;
}

/// A ball of radius 40 px.
relief::VisibleSheet whole_ball() {
  relief::VisibleSheet sheet{hemisphere(40, 64), {}, {}};
  for (const Point3 p : sheet.model.positions) sheet.back.push_back({-p.z, 0});
  return sheet;
}

SolidCensus figure_census(const Solid& solid) { return census_of_stl(stl_of(solid.model)); }

TEST(Figure, OfABallIsOne) {
  const auto solid = make_solid(whole_ball(), {}, figure_of(80));
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  const SolidCensus found = figure_census(*solid);
  EXPECT_EQ(what_is_wrong(found), "");
  EXPECT_EQ(found.pieces, 1);
  EXPECT_EQ(found.holes, 0);
  const double volume = 4.0 / 3 * std::numbers::pi * 40 * 40 * 40;
  EXPECT_NEAR(found.volume, volume, 0.01 * volume);
  // All of it lies near the sphere, and normals point outwards.
  const Model& model = solid->model;
  for (size_t v = 0; v < model.positions.size(); ++v) {
    const Point3 p = model.positions[v] - Point3{40, 40, 40};
    EXPECT_NEAR(norm(p), 40, 1);
    EXPECT_GT(dot(normalized(p), model.normals[v]), 0.8);
  }
}

TEST(Figure, HasTheDrawingOrThePartsColoursBehind) {
  for (const BackSide side : {BackSide::mirror, BackSide::parts}) {
    const auto solid = make_solid(whole_ball(), quarters(), figure_of(80, side));
    ASSERT_TRUE(solid.ok());
    const Model& model = solid->model;
    const double seam = static_cast<double>(quarters().rgba.height) / solid->drawing.rgba.height;
    for (const std::array<int, 3>& t : model.triangles) {
      const bool behind =
          std::all_of(t.begin(), t.end(), [&model](int v) { return model.normals[v].z < -0.2; });
      for (const int v : t)
        if (behind) {
          EXPECT_EQ(model.uvs[v].y > seam, side == BackSide::parts);
        }
    }
  }
}

/// A red disc below a ball of radius 40 px, with a contour of black ink 4 px wide. `eye`: whether
/// there is a black spot near the middle.
Drawing inked_disc(bool eye = false) {
  Drawing drawing{Image8(200, 200, 4, 255)};
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const double from_rim = 80 - std::hypot(x + 0.5 - 100, y + 0.5 - 100);
      if (from_rim < 0) continue;
      const bool spot = eye && std::hypot(x + 0.5 - 120, y + 0.5 - 80) < 12;
      const double red = spot ? 0 : std::clamp(from_rim - 7.5, 0.0, 1.0);
      drawing.rgba.at(x, y, 0) = static_cast<uint8_t>(std::lround(255 * red));
      drawing.rgba.at(x, y, 1) = drawing.rgba.at(x, y, 2) = 0;
    }
  return drawing;
}

/// Returns the mm^2 of a solid whose colour is dark. `behind`: of what faces backwards alone.
double dark_area(const Solid& solid, bool behind) {
  const Model& model = solid.model;
  const Image8& rgba = solid.drawing.rgba;
  double area = 0;
  for (const std::array<int, 3>& t : model.triangles) {
    const Point2 uv = (1.0 / 3) * (model.uvs[t[0]] + model.uvs[t[1]] + model.uvs[t[2]]);
    if (rgba.at(static_cast<int>(uv.x * rgba.width), static_cast<int>(uv.y * rgba.height), 0) > 128)
      continue;
    const Point3 a = model.positions[t[0]];
    const Point3 twice = cross(model.positions[t[1]] - a, model.positions[t[2]] - a);
    if (!behind || twice.z < 0) area += 0.5 * norm(twice);
  }
  return area;
}

SolidOptions inked_figure(Ink ink) {
  SolidOptions options = figure_of(80, BackSide::plain);
  options.ink = ink;
  return options;
}

TEST(Figure, LeavesContoursInThePaintOrOutOfIt) {
  const auto painted = make_solid(whole_ball(), inked_disc(), inked_figure(Ink::paint));
  const auto plain = make_solid(whole_ball(), inked_disc(), inked_figure(Ink::none));
  ASSERT_TRUE(painted.ok() && plain.ok());
  // Seen from the side, 4 mm of ink in front reach sqrt(40^2 - 36^2) deep.
  const double around = 2 * std::numbers::pi * 40;
  EXPECT_GT(dark_area(*painted, false), 0.8 * around * std::sqrt(40.0 * 40 - 36.0 * 36));
  EXPECT_EQ(dark_area(*plain, false), 0);
  EXPECT_TRUE(plain->model.ink.triangles.empty());
  EXPECT_EQ(plain->model.positions.size(), painted->model.positions.size());
  for (size_t v = 0; v < plain->model.positions.size(); ++v)
    EXPECT_EQ(norm(plain->model.positions[v] - painted->model.positions[v]), 0);
}

TEST(Figure, IsSurroundedByAClosedShellOfInk) {
  const auto solid = make_solid(whole_ball(), inked_disc(), inked_figure(Ink::shell));
  ASSERT_TRUE(solid.ok());
  EXPECT_EQ(dark_area(*solid, false), 0);
  const Model& model = solid->model;
  // The body ends at the inner edge of the contour, the shell at its outer edge.
  double body = 0;
  for (const Point3 p : model.positions) body = std::max(body, std::hypot(p.x - 40, p.y - 40));
  EXPECT_NEAR(body, 36, 0.5);
  std::map<std::pair<int, int>, int> edges;
  double shell = 0;
  double volume = 0;
  for (const std::array<int, 3>& t : model.ink.triangles) {
    std::array<Point3, 3> p;
    for (int k = 0; k < 3; ++k) {
      p[k] = model.ink.positions[t[k]];
      shell = std::max(shell, std::hypot(p[k].x - 40, p[k].y - 40));
      const int next = t[(k + 1) % 3];
      edges[{std::min(t[k], next), std::max(t[k], next)}] += t[k] < next ? 1 : -1;
    }
    volume += dot(p[0], cross(p[1], p[2])) / 6;
  }
  EXPECT_NEAR(shell, 40, 0.5);
  for (const auto& [edge, sum] : edges) EXPECT_EQ(sum, 0);
  // It is turned inside out. The ball was drawn in along the page, not in depth. Chords of half a
  // width of ink are allowed.
  const double pushed = 4.0 / 3 * std::numbers::pi * 40 * 40 * 44;
  EXPECT_NEAR(volume, -pushed, 0.1 * pushed);
}

TEST(Figure, HasNoFaceBehind) {
  SolidOptions options = inked_figure(Ink::none);
  const double spot = std::numbers::pi * 6 * 6;
  const auto plain = make_solid(whole_ball(), inked_disc(true), options);
  options.back = BackSide::mirror;
  const auto mirrored = make_solid(whole_ball(), inked_disc(true), options);
  ASSERT_TRUE(plain.ok() && mirrored.ok());
  EXPECT_EQ(dark_area(*plain, true), 0);
  EXPECT_GT(dark_area(*plain, false), spot);
  EXPECT_GT(dark_area(*mirrored, true), spot);
}

TEST(Figure, HasOneColourOnBothSidesOfTheSilhouette) {
  Drawing drawing{Image8(200, 200, 4, 255)};
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      drawing.rgba.at(x, y, 0) = static_cast<uint8_t>(55 + x);
      drawing.rgba.at(x, y, 1) = static_cast<uint8_t>(55 + y);
    }
  const auto solid = make_solid(whole_ball(), drawing, figure_of(80, BackSide::plain));
  ASSERT_TRUE(solid.ok());
  const Image8& rgba = solid->drawing.rgba;
  std::map<std::array<double, 3>, std::vector<int>> at;
  const Model& model = solid->model;
  for (size_t v = 0; v < model.positions.size(); ++v) {
    const Point3 p = model.positions[v];
    if (std::hypot(p.x - 40, p.y - 40) > 39.9) at[{p.x, p.y, p.z}].push_back(static_cast<int>(v));
  }
  int compared = 0;
  for (const auto& [place, vertices] : at)
    for (const int v : vertices)
      for (int c = 0; c < 3; ++c) {
        const auto colour = [&](int w) {
          const Point2 uv = model.uvs[w];
          return rgba.at(std::min(199, static_cast<int>(uv.x * 200)),
                         std::min(rgba.height - 1, static_cast<int>(uv.y * rgba.height)), c);
        };
        EXPECT_NEAR(colour(v), colour(vertices[0]), 3);
        compared += v != vertices[0] ? 1 : 0;
      }
  EXPECT_GT(compared, 100);
}

TEST(Figure, StandsOnAPlateOrADiscUnderItsFeet) {
  SolidOptions options = figure_of(80);
  options.thickness = 4;
  options.margin = 10;
  double rectangle = 0;
  for (const BaseShape base : {BaseShape::plate, BaseShape::round}) {
    options.base = base;
    const auto solid = make_solid(whole_ball(), {}, options);
    ASSERT_TRUE(solid.ok()) << to_string(solid.error());
    const SolidCensus found = figure_census(*solid);
    EXPECT_EQ(what_is_wrong(found), "");
    EXPECT_EQ(found.pieces, 1);
    // The ball of radius 39 touches with a disc as wide as it is 2 mm above its lowest point.
    const double foot = std::sqrt(39.0 * 39 - 37.0 * 37);
    const Model& model = solid->model;
    double low = 1e300;
    double left = 1e300;
    double right = -1e300;
    for (const Point3 p : model.positions) low = std::min(low, p.y);
    for (const Point3 p : model.positions)
      if (p.y == low) left = std::min(left, p.x), right = std::max(right, p.x);
    const double side = 2 * foot + 20;
    const double wide = base == BaseShape::plate ? side : std::sqrt(2.0) * 2 * foot + 20;
    EXPECT_NEAR(right - left, wide, 0.05 * wide);
    EXPECT_NEAR(extent(model).max.y - low, 80, 0.1);
    double sole = 0;
    for (const std::array<int, 3>& t : model.triangles) {
      const Point3 a = model.positions[t[0]];
      const Point3 twice = cross(model.positions[t[1]] - a, model.positions[t[2]] - a);
      if (a.y == low && twice.x == 0 && twice.z == 0) sole -= 0.5 * twice.y;
    }
    const double area = base == BaseShape::plate ? side * side : std::numbers::pi / 4 * wide * wide;
    EXPECT_NEAR(sole, area, 0.05 * area);
    EXPECT_GT(std::abs(sole - rectangle), 1);
    rectangle = sole;
    const double volume = 4.0 / 3 * std::numbers::pi * 39 * 39 * 39;
    EXPECT_NEAR(found.volume, volume + 4 * area, 0.02 * volume);
  }
}

TEST(Figure, StandsOnNothingElse) {
  SolidOptions options = figure_of(80);
  options.base = BaseShape::outline;
  EXPECT_EQ(make_solid(whole_ball(), {}, options).error().code, ErrorCode::usage);
  options.base = BaseShape::plate;
  options.ring = 4;
  EXPECT_EQ(make_solid(whole_ball(), {}, options).error().code, ErrorCode::usage);
}

TEST(Figure, KeepsWithinAHeight) {
  SolidOptions options = figure_of(80);
  options.height = 20;
  const auto solid = make_solid(whole_ball(), {}, options);
  ASSERT_TRUE(solid.ok());
  const Box3 box = extent(solid->model);
  EXPECT_NEAR(box.max.z - box.min.z, 20, 0.1);
  EXPECT_NEAR(box.max.x - box.min.x, 80, 1e-3);
}

class RandomFigure : public ::testing::TestWithParam<int> {};

TEST_P(RandomFigure, IsClosedAndShowsTheRelief) {
  const Scene scene = random_scene(static_cast<uint64_t>(GetParam()));
  const relief::VisibleSheet sheet = sheet_of(scene, 1500, true);
  const auto solid = make_solid(sheet, {}, figure_of(128));
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  const SolidCensus found = figure_census(*solid);
  EXPECT_EQ(what_is_wrong(found), "");
  EXPECT_EQ(found.pieces, solid->facts.pieces);
  EXPECT_NEAR(found.volume, solid->facts.volume, 1e-5 * found.volume);

  // The front is the relief's, but for the few vertices that had to rise.
  const Box3 box = extent(sheet.model);
  double low = box.min.z;
  for (const relief::BackPoint& back : sheet.back) low = std::min(low, back.z);
  const double scale =
      128 / std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - low});
  const double unit = std::ldexp(1.0, 8 - 24);
  std::map<std::pair<double, double>, std::vector<double>> columns;
  for (const Point3 p : solid->model.positions) columns[{p.x, p.y}].push_back(p.z);
  int missing = 0;
  for (const std::array<int, 3>& t : sheet.model.triangles)
    for (const int v : t) {
      const Point3 p = scale * (sheet.model.positions[v] - Point3{box.min.x, box.min.y, low});
      const auto column =
          columns.find({unit * std::round(p.x / unit), unit * std::round(p.y / unit)});
      const auto near = [&p, unit](double z) { return std::abs(z - p.z) <= unit; };
      missing +=
          column != columns.end() && std::any_of(column->second.begin(), column->second.end(), near)
              ? 0
              : 1;
    }
  EXPECT_LE(missing, 6 + static_cast<int>(sheet.model.triangles.size()) / 500);
}

TEST_P(RandomFigure, StandsClosed) {
  const Scene scene = random_scene(static_cast<uint64_t>(GetParam()));
  SolidOptions options = figure_of(128, BackSide::parts);
  options.base = GetParam() % 2 == 0 ? BaseShape::plate : BaseShape::round;
  const auto solid = make_solid(sheet_of(scene, 1500, true), quarters(), options);
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  const SolidCensus found = figure_census(*solid);
  EXPECT_EQ(what_is_wrong(found), "");
  EXPECT_EQ(found.pieces, solid->facts.pieces);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RandomFigure, ::testing::Range(0, 20));
INSTANTIATE_TEST_SUITE_P(SolidSurvey, RandomFigure, ::testing::Range(20, 100));

}  // namespace
}  // namespace relievo

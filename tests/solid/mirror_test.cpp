#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/mesh/placement.h"
#include "kernel/meshing/unite_meshes.h"
#include "relief/surface/assemble_limbs.h"
#include "solid/make_solid.h"
#include "solid/solid_case.h"
#include "support/random_scene.h"
#include "support/sample_models.h"
#include "support/solid_checks.h"

namespace relievo {
namespace {

using namespace testing;

constexpr double unit = 1.0 / 65536;

SolidOptions figure_with(std::vector<std::string> limbs, BackSide back = BackSide::mirror) {
  SolidOptions options;
  options.size = 128;
  options.back = back;
  options.mirror = std::move(limbs);
  return options;
}

/// A figure of a scene whose relief is given.
Result<Solid> figure_of(const Scene& scene, const relief::Relief& relief,
                        const SolidOptions& options, const Drawing& drawing = {}) {
  const auto limbs = relief::assemble_limbs(
      {relief.layers, relief.inflation, relief.ordering, scene}, options.mirror);
  if (!limbs) return limbs.error();
  return make_solid(sheet_of(scene, relief), *limbs, drawing, options);
}

Result<Solid> figure_of(const Scene& scene, const SolidOptions& options,
                        const Drawing& drawing = {}) {
  const auto relief = relief_of(scene, 3000, true);
  if (!relief) return relief.error();
  return figure_of(scene, *relief, options, drawing);
}

/// Where an upright line goes through a model, from the back to the front.
std::vector<double> heights_at(const Model& model, double x, double y) {
  std::vector<double> heights;
  for (const auto& [a, b, c] : model.triangles) {
    const Point3 p = model.positions[a];
    const Point3 q = model.positions[b];
    const Point3 r = model.positions[c];
    const auto side = [x, y](Point3 s, Point3 t) {
      return (t.x - s.x) * (y - s.y) - (t.y - s.y) * (x - s.x);
    };
    const double u = side(q, r);
    const double v = side(r, p);
    const double w = side(p, q);
    if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) continue;
    heights.push_back((u * p.z + v * q.z + w * r.z) / (u + v + w));
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// Places on the leg of body_and_leg below its body, in mm from the box's corner: it is 40 px wide,
/// its middle 100 px from the left; 220 px are 128 mm.
std::vector<Point2> places_on_leg(double scale) {
  std::vector<Point2> places;
  for (const double y : {13.3, 31.7, 49.1, 63.9})
    for (const double x : {87.1, 93.3, 99.7, 107.9, 112.3})
      places.push_back({scale * x, scale * y});
  return places;
}

TEST(Mirror, GivesALegToTheFarSide) {
  const Scene scene = body_and_leg();
  const auto plain = figure_of(scene, figure_with({}));
  const auto both = figure_of(scene, figure_with({"leg"}));
  ASSERT_TRUE(plain.ok());
  ASSERT_TRUE(both.ok()) << to_string(both.error());
  const SolidCensus found = census_of_stl(stl_of(both->model));
  EXPECT_EQ(what_is_wrong(found), "");
  EXPECT_EQ(found.pieces, 1);
  EXPECT_EQ(both->facts.pieces, 1);
  EXPECT_NEAR(found.volume, both->facts.volume, 1e-5 * found.volume);
  EXPECT_GT(both->facts.volume, 1.02 * plain->facts.volume);
  std::set<double> middles;
  std::set<double> moved;
  for (const Point2 p : places_on_leg(128.0 / 220)) {
    SCOPED_TRACE(std::to_string(p.x) + ", " + std::to_string(p.y));
    const std::vector<double> one = heights_at(plain->model, p.x, p.y);
    const std::vector<double> two = heights_at(both->model, p.x, p.y);
    ASSERT_EQ(one.size(), 2U);
    // One leg before the other, or both as one.
    ASSERT_TRUE(two.size() == 2 || two.size() == 4) << two.size();
    middles.insert(two.front() + two.back());
    moved.insert(two.back() - one.back());
    if (two.size() == 4) {
      EXPECT_NEAR(two[1] - two[0], two[3] - two[2], 0.15);
    }
  }
  // All are mirrored about one plane, and the front is as it was.
  EXPECT_NEAR(*middles.begin(), *middles.rbegin(), 0.06);
  EXPECT_NEAR(*moved.begin(), *moved.rbegin(), 2 * unit);
}

TEST(Mirror, WearsThePaintOfTheLimb) {
  for (const BackSide side : {BackSide::mirror, BackSide::parts}) {
    const auto solid = figure_of(body_and_leg(), figure_with({"leg"}, side), quarters());
    ASSERT_TRUE(solid.ok()) << to_string(solid.error());
    const Model& model = solid->model;
    const double seam = static_cast<double>(quarters().rgba.height) / solid->drawing.rgba.height;
    const ModelPart& leg = model.parts[1];
    int behind = 0;
    for (int t = leg.first_triangle; t < leg.first_triangle + leg.triangle_count; ++t)
      for (const int v : model.triangles[t]) {
        if (model.normals[v].z > -0.5 || model.positions[v].y > 60) continue;
        ++behind;
        EXPECT_EQ(model.uvs[v].y > seam, side == BackSide::parts);
        if (side == BackSide::mirror) {
          EXPECT_NEAR(400 * model.uvs[v].x, 100 + model.positions[v].x * 220 / 128, 3);
        }
      }
    EXPECT_GT(behind, 100);
  }
}

TEST(Mirror, StandsOnAllFeet) {
  SolidOptions options = figure_with({"leg"});
  for (const BaseShape base : {BaseShape::plate, BaseShape::round}) {
    options.base = base;
    const auto solid = figure_of(body_and_leg(), options);
    ASSERT_TRUE(solid.ok()) << to_string(solid.error());
    const SolidCensus found = census_of_stl(stl_of(solid->model));
    EXPECT_EQ(what_is_wrong(found), "");
    EXPECT_EQ(found.pieces, 1);
    const Model& model = solid->model;
    double back = 1e300;
    double plate = 1e300;
    for (int t = 0; t < static_cast<int>(model.triangles.size()); ++t)
      for (const int v : model.triangles[t]) {
        const bool of_plate = t >= model.parts.back().first_triangle;
        const Point3 p = model.positions[v];
        if (of_plate)
          plate = std::min(plate, p.z);
        else if (p.y <= options.thickness)
          back = std::min(back, p.z);
      }
    EXPECT_LT(plate, back - 2.5);
  }
}

TEST(Mirror, IsRefusedByName) {
  const Scene scene = body_and_leg();
  for (const std::string& id : std::vector<std::string>{"body", "wing"}) {
    const auto solid = figure_of(scene, figure_with({id}));
    ASSERT_FALSE(solid.ok());
    EXPECT_EQ(solid.error().code, ErrorCode::usage);
    EXPECT_NE(solid.error().message.find(id), std::string::npos);
  }
  EXPECT_EQ(figure_of(scene, figure_with({"leg"}, BackSide::flat)).error().code, ErrorCode::usage);
  SolidOptions options = figure_with({"leg"});
  options.detail = true;
  EXPECT_EQ(figure_of(scene, options).error().code, ErrorCode::usage);
}

/// The solid's points and triangles alone.
ClosedMesh closed_mesh(const Model& model) {
  ClosedMesh mesh;
  std::map<std::tuple<double, double, double>, int> numbers;
  std::vector<int> place;
  for (const Point3 p : model.positions) {
    const auto [at, fresh] =
        numbers.try_emplace({p.x, p.y, p.z}, static_cast<int>(mesh.points.size()));
    if (fresh) mesh.points.push_back(p);
    place.push_back(at->second);
  }
  for (const auto& [a, b, c] : model.triangles)
    mesh.triangles.push_back({place[a], place[b], place[c]});
  return mesh;
}

/// A binary STL file of a mesh where it is.
std::string stl_in_place(const ClosedMesh& mesh) {
  std::string stl(80, ' ');
  const auto append = [&stl](auto value) {
    stl.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const Point3 p : {Point3{}, mesh.points[a], mesh.points[b], mesh.points[c]})
      for (const double value : {p.x, p.y, p.z}) append(static_cast<float>(value));
    append(uint16_t{0});
  }
  return stl;
}

class RandomMirror : public ::testing::TestWithParam<int> {
 protected:
  uint64_t seed() const { return 5000 + static_cast<uint64_t>(GetParam()); }
};

TEST_P(RandomMirror, IsOneSolidWithTheFigure) {
  const Scene scene = random_scene(seed());
  const auto relief = relief_of(scene, 1500, true);
  if (!relief) {
    EXPECT_EQ(relief.error().code, ErrorCode::bad_input);  // joins that do not fit
    return;
  }
  // All that are off the middle.
  std::vector<std::string> limbs;
  for (const Join& join : scene.joins) {
    const std::string& id = scene.parts[join.upper].id;
    const auto limb =
        relief::assemble_limbs({relief->layers, relief->inflation, relief->ordering, scene}, {id});
    if (limb)
      limbs.push_back(id);
    else
      EXPECT_EQ(limb.error().code, ErrorCode::usage);
  }
  const auto plain = figure_of(scene, *relief, figure_with({}));
  ASSERT_TRUE(plain.ok());
  const auto solid = figure_of(scene, *relief, figure_with(limbs));
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  const SolidCensus found = census_of_stl(stl_of(solid->model));
  EXPECT_EQ(what_is_wrong(found), "");
  EXPECT_EQ(found.pieces, solid->facts.pieces);
  EXPECT_LE(found.pieces, plain->facts.pieces);
  EXPECT_NEAR(found.volume, solid->facts.volume, 1e-5 * found.volume);
}

/// Two figures that have nothing to do with each other, one through the other.
TEST_P(RandomMirror, UnitesWhatCrosses) {
  for (const uint64_t scene : {seed(), seed() + 500})
    if (const auto relief = relief_of(random_scene(scene), 1500, true); !relief) {
      EXPECT_EQ(relief.error().code, ErrorCode::bad_input);  // joins that do not fit
      return;
    }
  const auto one = make_solid(sheet_of(random_scene(seed()), 1500, true), {}, figure_with({}));
  const auto two =
      make_solid(sheet_of(random_scene(seed() + 500), 1500, true), {}, figure_with({}));
  ASSERT_TRUE(one.ok() && two.ok());
  const ClosedMesh a = closed_mesh(one->model);
  ClosedMesh b = closed_mesh(two->model);
  for (Point3& p : b.points) p = p + Point3{0, 0, 1.25};
  const SolidCensus shared = shared_by_stl(stl_in_place(a), stl_in_place(b));
  const auto both = unite_meshes(a, b, unit);
  ASSERT_TRUE(both.ok());
  const SolidCensus found = census_of_stl(stl_in_place(both->mesh));
  EXPECT_EQ(what_is_wrong(found), "");
  const SolidCensus first = census_of_stl(stl_in_place(a));
  const SolidCensus second = census_of_stl(stl_in_place(b));
  EXPECT_NEAR(found.volume, first.volume + second.volume - shared.volume + both->filled,
              1e-5 * found.volume);
  if (both->filled > 0) return;
  const auto euler = [](const SolidCensus& solid) { return 2 * (solid.pieces - solid.holes); };
  EXPECT_EQ(euler(found), euler(first) + euler(second) - euler(shared));
}

INSTANTIATE_TEST_SUITE_P(Scenes, RandomMirror, ::testing::Range(0, 12));
INSTANTIATE_TEST_SUITE_P(SolidSurvey, RandomMirror, ::testing::Range(12, 120));

}  // namespace
}  // namespace relievo

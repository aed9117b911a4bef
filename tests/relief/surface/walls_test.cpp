#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "support/analytic_discs.h"
#include "support/model_checks.h"

namespace relievo::relief {
namespace {

void expect_open_at_silhouette_only(const DiscRelief& relief, const Model& model) {
  const SilhouetteCensus census = count_silhouette(model, relief.mesh);
  EXPECT_EQ(census.elsewhere, 0);
  EXPECT_EQ(census.along, census.outline);
  EXPECT_EQ(count_edges(model, false).repeated, 0);
}

std::vector<Disc> three_discs(double lift) {
  return {{{90, 100}, 60}, {{160, 100}, 50, 1, lift, {0.1, 0.05}}, {{125, 140}, 40, 1, 2 * lift}};
}

TEST(Walls, OverlappingDiscsAreClosedUpToTheSilhouette) {
  for (const double lift : {-30.0, 0.0, 30.0}) {
    const DiscRelief relief = make_discs(three_discs(lift), 220, 200, 6);
    const Model model = assemble(relief);
    EXPECT_LT(sheet_triangles(model).size(), model.triangles.size());
    expect_open_at_silhouette_only(relief, model);
  }
}

TEST(Walls, WithoutThemTheReliefWouldBeOpen) {
  const DiscRelief relief = make_discs(three_discs(30), 220, 200, 6);
  Model model = assemble(relief);
  model.triangles = sheet_triangles(model);
  EXPECT_GT(count_edges(model, true).open, count_silhouette(model, relief.mesh).outline);
}

/// A small disc in a ball, raised above it, a bowl sunk into it and a disc sunk into it: all walls
/// are round about (90, 100).
struct RoundWall {
  double d;
  double lift;
  double facing;  ///< 1 outwards, -1 inwards
};

class RoundWalls : public ::testing::TestWithParam<RoundWall> {};

TEST_P(RoundWalls, StandUprightAndFaceTheLowerSide) {
  const auto [d, lift, facing] = GetParam();
  const DiscRelief relief = make_discs({{{90, 100}, 60}, {{90, 100}, 30, d, lift}}, 220, 200, 6);
  const Model model = assemble(relief);
  int walls = 0;
  for (const auto& t : model.triangles) {
    if (!is_wall(model, t)) continue;
    ++walls;
    const Point3 a = model.positions[t[0]];
    const Point3 side = normalized(cross(model.positions[t[1]] - a, model.positions[t[2]] - a));
    EXPECT_NEAR(side.z, 0, 1e-9);
    for (const int v : t) {
      const Point3 radial = normalized({model.positions[v].x - 90, model.positions[v].y - 100, 0});
      EXPECT_NEAR(norm(model.normals[v]), 1, 1e-12);
      EXPECT_GT(dot(model.normals[v], side), 0.98);
      EXPECT_GT(dot(model.normals[v], facing * radial), 0.9999);
    }
  }
  EXPECT_GE(walls, 2 * static_cast<int>(relief.scene.parts[1].outline[0].size()));
}

INSTANTIATE_TEST_SUITE_P(Walls, RoundWalls,
                         ::testing::Values(RoundWall{1, 80, 1}, RoundWall{-1, 80, 1},
                                           RoundWall{-1, 20, -1}, RoundWall{1, 20, -1}));

TEST(Walls, DoNotFoldBelowAnOverhangingEdge) {
  const DiscRelief relief = make_discs({{{90, 100}, 60}, {{190, 100}, 50, 1, 34}}, 250, 200, 6);
  const Model model = assemble(relief);
  for (const auto& t : model.triangles) {
    if (!is_wall(model, t)) continue;
    const Point3 a = model.positions[t[0]];
    const Point3 side = cross(model.positions[t[1]] - a, model.positions[t[2]] - a);
    for (const int v : t) EXPECT_GT(dot(model.normals[v], side), 0);
  }
}

TEST(Walls, BelongToTheHigherPart) {
  for (const double lift : {-70.0, 80.0}) {
    const DiscRelief relief = make_discs({{{90, 100}, 60}, {{90, 100}, 30, 1, lift}}, 220, 200, 6);
    const Model model = assemble(relief);
    const int higher = lift > 0 ? 1 : 0;
    EXPECT_LT(sheet_triangles(model, higher).size(),
              static_cast<size_t>(model.parts[higher].triangle_count));
    EXPECT_EQ(sheet_triangles(model, 1 - higher).size(),
              static_cast<size_t>(model.parts[1 - higher].triangle_count));
    expect_open_at_silhouette_only(relief, model);
  }
}

TEST(Walls, AreNotNeededWhereHeightsAgree) {
  const double rim = std::sqrt(60.0 * 60 - 30 * 30);
  DiscRelief relief = make_discs({{{90, 100}, 60}, {{90, 100}, 30, 1, rim}}, 220, 200, 6);
  const Model model = assemble(relief);
  EXPECT_EQ(sheet_triangles(model).size(), model.triangles.size());
  expect_open_at_silhouette_only(relief, model);
}

TEST(Walls, RoundingOfEqualHeightsIsWelded) {
  const double rim = std::sqrt(60.0 * 60 - 30 * 30);
  DiscRelief relief = make_discs({{{90, 100}, 60}, {{90, 100}, 30, 1, rim}}, 220, 200, 6);
  for (size_t n = 0; n < relief.ordering.h.size(); ++n)
    relief.ordering.h[n] += 1e-11 * static_cast<double>(n % 3);
  const Model model = assemble(relief);
  EXPECT_EQ(sheet_triangles(model).size(), model.triangles.size());
  EXPECT_EQ(count_edges(model, true).crowded, 0);
  expect_open_at_silhouette_only(relief, model);
}

TEST(Walls, CrossingProfilesLeaveNoFinAboveTheSurface) {
  const DiscRelief relief =
      make_discs({{{90, 100}, 60}, {{90, 100}, 30, 1, 51, {3, 1}}}, 220, 200, 6);
  const Model model = assemble(relief);
  expect_open_at_silhouette_only(relief, model);
  std::vector<double> tops;
  for (const auto& t : model.triangles) {
    if (!is_wall(model, t)) continue;
    for (const double s : {0.25, 0.5, 0.75})
      for (int k = 0; k < 3; ++k) {
        const Point3 a = model.positions[t[k]];
        const Point3 p = a + s * (model.positions[t[(k + 1) % 3]] - a);
        const Point2 place{p.x, 200 - p.y};
        const double top = std::max(disc_height({{90, 100}, 60}, place),
                                    51 + 3 * (place.x - 90) + (place.y - 100));
        tops.push_back(p.z - top);
      }
  }
  ASSERT_FALSE(tops.empty());
  EXPECT_LT(*std::max_element(tops.begin(), tops.end()), 0.5);
}

TEST(Walls, SheetsForOrbitStayOpenWhereNothingIsCutAway) {
  const DiscRelief relief = make_discs(three_discs(30), 220, 200, 6);
  for (const Visibility visibility : {Visibility::orbit, Visibility::all}) {
    const Model model = assemble(relief, visibility);
    size_t outlines = 0;
    for (const Part& part : relief.scene.parts) outlines += part.outline[0].size();
    const EdgeCensus census = count_edges(model, false);
    EXPECT_EQ(census.open, static_cast<int>(outlines));
    EXPECT_EQ(census.crowded, 0);
    EXPECT_EQ(sheet_triangles(model).size(), model.triangles.size());
  }
}

}  // namespace
}  // namespace relievo::relief

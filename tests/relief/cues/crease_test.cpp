#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "relief/maps/relief_maps.h"
#include "relief/session/build_relief.h"
#include "relief/surface/assemble_model.h"
#include "support/model_checks.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace relievo::relief {
namespace {

using namespace testing;

constexpr double degree = M_PI / 180;

/// A thin plate, turned around the middle of the canvas, with a crease from `from` to `to` of its
/// width along its middle.
Scene plate(double from, double to, double angle, double turn = 0) {
  const auto at = [&](double x, double y) {
    return Point2{200 + std::cos(turn) * x - std::sin(turn) * y,
                  200 + std::sin(turn) * x + std::cos(turn) * y};
  };
  Scene scene = canvas();
  scene.parts = {part("plate", {at(-150, -80), at(150, -80), at(150, 80), at(-150, 80)}, 0.01)};
  scene.cues = {{0, CueKind::crease, {at(300 * from - 150, 0), at(300 * to - 150, 0)}, angle}};
  return scene;
}

Relief built(const Scene& scene, double edge) {
  ReliefOptions options;
  options.layers.edge_length = edge;
  Result<Relief> relief = build_relief(scene, options);
  EXPECT_TRUE(relief) << to_string(relief.error());
  return std::move(*relief);
}

Point2 vertex(const Relief& relief, int corner) {
  const LayeredMesh& mesh = relief.layers;
  return mesh.vertices[mesh.node_vertex[mesh.faces[corner / 3][corner % 3]]];
}

bool on_crease(const Relief& relief, int corner) {
  const auto& faces = relief.layers.faces;
  const int node = faces[corner / 3][corner % 3];
  const auto ends_at = [&](const CreaseEdge& edge) {
    const auto& face = faces[edge.corner[0] / 3];
    return face[(edge.corner[0] + 1) % 3] == node || face[(edge.corner[0] + 2) % 3] == node;
  };
  const auto& creases = relief.layers.creases;
  return std::any_of(creases.begin(), creases.end(), ends_at);
}

/// Measures the jump of the gradient of g at each node of the crease within `reach` of the middle
/// of the canvas.
std::vector<double> jumps(const Relief& relief, double reach) {
  const CreaseGradients& creases = relief.ordering.creases;
  std::map<int, std::vector<Point2>> sides;
  for (size_t i = 0; i < creases.corner.size(); ++i) {
    const int corner = creases.corner[i];
    if (distance(vertex(relief, corner), {200, 200}) > reach || !on_crease(relief, corner))
      continue;
    sides[relief.layers.faces[corner / 3][corner % 3]].push_back(creases.gradient[i]);
  }
  std::vector<double> jumps;
  for (const auto& [node, gradients] : sides) {
    double most = 0;
    for (const Point2 gradient : gradients) most = std::max(most, norm(gradient - gradients[0]));
    jumps.push_back(most);
  }
  return jumps;
}

TEST(Crease, LiesOnEdgesOfTheMesh) {
  const Relief relief = built(plate(0.2, 0.8, 30, 0.3), 8);
  double length = 0;
  for (const CreaseEdge& edge : relief.layers.creases) {
    const Point2 a = vertex(relief, edge.corner[0] / 3 * 3 + (edge.corner[0] + 1) % 3);
    const Point2 b = vertex(relief, edge.corner[0] / 3 * 3 + (edge.corner[0] + 2) % 3);
    const Point2 across = {-std::sin(0.3), std::cos(0.3)};
    for (const Point2 p : {a, b}) EXPECT_NEAR(dot(p - Point2{200, 200}, across), 0, 1e-9);
    length += distance(a, b);
  }
  EXPECT_NEAR(length, 180, 1e-6);
}

/// From rim to rim the plate is a roof: g falls by tan(angle) per px on both sides.
TEST(Crease, FromRimToRimMakesARoof) {
  for (const double angle : {35.0, -20.0})
    for (const double turn : {0.0, 0.4}) {
      const Relief relief = built(plate(-0.1, 1.1, angle, turn), 10);
      const double slope = std::tan(angle * degree);
      const Point2 across = {-std::sin(turn), std::cos(turn)};
      const auto rise = [&](size_t n) {
        const Point2 p = relief.layers.vertices[relief.layers.node_vertex[n]];
        return -slope * std::abs(dot(p - Point2{200, 200}, across));
      };
      for (size_t n = 0; n < relief.ordering.g.size(); ++n)
        EXPECT_NEAR(relief.ordering.g[n] - relief.ordering.g[0], rise(n) - rise(0), 1e-6);
      for (const Point2 gradient : relief.ordering.creases.gradient)
        EXPECT_NEAR(norm(gradient), std::abs(slope), 1e-6);
    }
}

TEST(Crease, IsExtendedToARimThatItNearlyReaches) {
  const Relief relief = built(plate(0.008, 0.992, 35), 10);
  for (const Point2 gradient : relief.ordering.creases.gradient)
    EXPECT_NEAR(norm(gradient), std::tan(35 * degree), 1e-6);
}

/// The slope jumps by twice tan(angle) on every mesh, whatever else shapes the surface.
TEST(Crease, DihedralAngleDoesNotDependOnTheMesh) {
  for (const double edge : {16.0, 8.0, 4.0, 2.0})
    for (const double turn : {0.0, 0.5}) {
      const Relief relief = built(plate(0.2, 0.8, 40, turn), edge);
      const std::vector<double> found = jumps(relief, 40);
      ASSERT_FALSE(found.empty());
      for (const double jump : found)
        EXPECT_NEAR(2 * std::atan(jump / 2) / degree, 80, 0.2 * edge) << edge << " " << turn;
    }
}

TEST(Crease, KeepsItsAngleAlongABend) {
  Scene scene = canvas();
  scene.parts = {part("disc", circle({200, 200}, 150), 0.01)};
  std::vector<Point2> arc;
  for (int i = 0; i <= 40; ++i) {
    const double a = M_PI * (1 + i / 40.0);
    arc.push_back({200 + 70 * std::cos(a), 235 + 70 * std::sin(a)});
  }
  scene.cues = {{0, CueKind::crease, arc, 30}};
  const Relief relief = built(scene, 5);
  const std::vector<double> found = jumps(relief, 60);
  ASSERT_GT(found.size(), 5u);
  for (const double jump : found) EXPECT_NEAR(2 * std::atan(jump / 2) / degree, 60, 3);
}

TEST(Crease, NormalsDifferOnBothSidesOfTheModel) {
  const Scene scene = plate(0.2, 0.8, 40);
  const Relief relief = built(scene, 8);
  const Result<Model> model = assemble_model(
      {relief.layers, relief.inflation, relief.ordering, scene}, {Visibility::relief});
  ASSERT_TRUE(model);
  std::map<std::tuple<double, double, double>, std::vector<Point3>> normals;
  for (size_t v = 0; v < model->positions.size(); ++v) {
    const Point3 p = model->positions[v];
    if (p.x > 150 && p.x < 250 && std::abs(p.y - 200) < 1)
      normals[{p.x, p.y, p.z}].push_back(model->normals[v]);
  }
  ASSERT_FALSE(normals.empty());
  for (const auto& [place, both] : normals) {
    ASSERT_EQ(both.size(), 2u);
    EXPECT_NEAR(std::acos(dot(both[0], both[1])) / degree, 80, 5);
  }
}

TEST(Crease, LeavesTheModelClosed) {
  Scene scene = plate(-0.1, 1.1, 35, 0.2);
  scene.parts[0].c = 4;
  scene.parts.push_back(part("ball", circle({220, 210}, 50)));
  scene.cues.push_back({1, CueKind::crease, {{170, 190}, {280, 230}}, -30});
  const Relief relief = built(scene, 8);
  const Result<Model> model = assemble_model(
      {relief.layers, relief.inflation, relief.ordering, scene}, {Visibility::relief});
  ASSERT_TRUE(model);
  const SilhouetteCensus census = count_silhouette(*model, relief.layers);
  EXPECT_EQ(census.along, census.outline);
  EXPECT_EQ(census.elsewhere, 0);
  EXPECT_EQ(count_edges(*model, true).crowded, 0);
}

TEST(Crease, NormalMapsTurnFromOnePixelToTheNext) {
  const Scene scene = plate(0.2, 0.8, 40);
  const Relief relief = built(scene, 8);
  const auto maps =
      rasterize_relief({relief.layers, relief.inflation, relief.ordering, scene}, 400, 400);
  ASSERT_TRUE(maps);
  for (const int x : {150, 200, 250}) {
    const auto normal = [&](int y) {
      return Point3{maps->normal.at(x, y, 0), maps->normal.at(x, y, 1), maps->normal.at(x, y, 2)};
    };
    EXPECT_NEAR(std::acos(dot(normal(199), normal(200))) / degree, 80, 5);
    EXPECT_LE(std::acos(std::min(1.0, dot(normal(190), normal(199)))) / degree, 15);
  }
  // The normal does not oscillate beside the crease.
  for (int x = 140; x < 260; ++x)
    EXPECT_NEAR(maps->normal.at(x, 195, 1), maps->normal.at(x + 1, 195, 1), 0.01);
}

/// Adds random cues of all kinds that cross outlines, joins and each other.
void scribble_cues(Random& random, Scene& scene) {
  for (int i = 0; i < 9; ++i) {
    const int part = random.integer(0, static_cast<int>(scene.parts.size()) - 1);
    const Box2 box = bounding_box(scene.parts[part].outline);
    Cue cue{part, static_cast<CueKind>(i % 3), {}, random.uniform(0.5, 40)};
    if (cue.kind == CueKind::bulge) cue.value /= 10;
    for (int k = random.integer(2, 5); k > 0; --k)
      cue.line.push_back({random.uniform(box.min.x - 9, box.max.x + 9),
                          random.uniform(box.min.y - 9, box.max.y + 9)});
    scene.cues.push_back(std::move(cue));
  }
}

TEST(Crease, RandomCuesOnRandomScenesAreSolvedToTheEnd) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Scene scene = random_scene(seed);
    ReliefOptions options;
    options.layers.vertex_budget = 3000;
    if (!build_relief(scene, options)) continue;
    scribble_cues(random, scene);
    const Result<Relief> relief = build_relief(scene, options);
    ASSERT_TRUE(relief) << seed << " " << to_string(relief.error());
    EXPECT_LE(relief->ordering.report.stationarity, 1e-12) << seed;
    EXPECT_LE(relief->ordering.max_violation, 1e-9) << seed;
    const Result<Model> model = assemble_model(
        {relief->layers, relief->inflation, relief->ordering, scene}, {Visibility::relief});
    ASSERT_TRUE(model) << seed << " " << to_string(model.error());
    EXPECT_EQ(count_silhouette(*model, relief->layers).elsewhere, 0) << seed;
  }
}

TEST(Crease, TheVertexBudgetHolds) {
  ReliefOptions options;
  options.layers.vertex_budget = 6000;
  const Result<Relief> relief = build_relief(plate(0.1, 0.9, 40, 0.3), options);
  ASSERT_TRUE(relief);
  EXPECT_NEAR(static_cast<double>(relief->layers.node_vertex.size()), 6000, 300);
}

TEST(Crease, LeavesTheMeshAloneOutsideItsPart) {
  Scene scene = plate(2, 3, 40);
  const Relief with = built(scene, 8);
  EXPECT_TRUE(with.layers.creases.empty());
  scene.cues.clear();
  EXPECT_EQ(built(scene, 8).ordering.h, with.ordering.h);
}

}  // namespace
}  // namespace relievo::relief

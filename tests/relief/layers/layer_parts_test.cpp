#include "relief/layers/layer_parts.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <set>

#include "support/mesh_checks.h"
#include "support/scenes.h"

namespace relievo::relief {
namespace {

using namespace testing;

LayeredMesh layers_of(const Scene& scene, double edge = 5) {
  LayerOptions options;
  options.edge_length = edge;
  auto mesh = layer_parts(scene, options);
  EXPECT_TRUE(mesh.ok()) << (mesh.ok() ? "" : to_string(mesh.error()));
  if (!mesh.ok()) return {};
  EXPECT_EQ(inconsistency(*mesh), "");
  const Manifoldness m = check_manifold(*mesh);
  EXPECT_EQ(m.repeated_edges, 0);
  EXPECT_EQ(m.bow_ties, 0);
  return *mesh;
}

double covered_area(const LayeredMesh& mesh, int part) {
  double area = 0;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.face_part[f] != part) continue;
    const auto& [a, b, c] = mesh.triangles[mesh.face_triangle[f]];
    area += 0.5 * cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
  }
  return area;
}

TEST(LayerParts, CoversEachPartExactly) {
  Scene scene = canvas();
  scene.parts = {part("a", rectangle(50, 50, 250, 200)), part("b", rectangle(150, 120, 350, 300))};
  const LayeredMesh mesh = layers_of(scene);
  EXPECT_NEAR(covered_area(mesh, 0), 200 * 150, 1e-6);
  EXPECT_NEAR(covered_area(mesh, 1), 200 * 180, 1e-6);
  EXPECT_EQ(check_manifold(mesh).components, 2);
}

TEST(LayerParts, HolesStayOpen) {
  Scene scene = canvas();
  Part ring = part("ring", rectangle(50, 50, 250, 250));
  ring.outline.push_back({{100, 100}, {100, 200}, {200, 200}, {200, 100}});
  scene.parts = {ring};
  EXPECT_NEAR(covered_area(layers_of(scene), 0), 200 * 200 - 100 * 100, 1e-6);
}

TEST(LayerParts, SelfCrossingOutlineFollowsTheNonZeroRule) {
  Scene scene = canvas();
  Ring star;  // a pentagram: its middle has winding number 2
  for (int i = 0; i < 5; ++i) {
    const double a = 4 * M_PI * i / 5;
    star.push_back({200 + 150 * std::cos(a), 200 + 150 * std::sin(a)});
  }
  scene.parts = {part("star", star)};
  const LayeredMesh mesh = layers_of(scene);
  const double filled = 150 * 150 * 1.12256994;  // 5 kites of the pentagram, middle included
  EXPECT_NEAR(covered_area(mesh, 0), filled, 0.01 * filled);
}

TEST(LayerParts, JoinedPartsAreOneSurface) {
  const LayeredMesh mesh = layers_of(body_and_leg());
  EXPECT_EQ(check_manifold(mesh).components, 1);
  EXPECT_EQ(mesh.ramps.size(), 2u);
  for (const RobinRamp& ramp : mesh.ramps) EXPECT_NEAR(ramp.length, 60, 1e-6);
  int seam = 0;
  int flap = 0;
  for (const NodeRole role : mesh.node_role) {
    seam += role == NodeRole::seam;
    flap += role == NodeRole::flap;
  }
  EXPECT_EQ(seam, flap + 2);
}

TEST(LayerParts, MarksThatDifferByRoundingAreOne) {
  Scene scene = body_and_leg();
  const Point2 end = scene.joins[0].line.back();
  const Point2 exit{end.x, end.y + 40};
  scene.robin.push_back({1, 0, {end.x, end.y + 1e-12}, exit, std::nullopt, std::nullopt});
  const LayeredMesh mesh = layers_of(scene);
  double shortest = 1e300;
  for (const auto& [a, b, c] : mesh.triangles)
    shortest = std::min(shortest, distance(mesh.vertices[a], mesh.vertices[b]));
  EXPECT_GT(shortest, 0.01 * mesh.edge_length);
}

TEST(LayerParts, BudgetIsMet) {
  for (const int budget : {5000, 20000, 40000}) {
    LayerOptions options;
    options.vertex_budget = budget;
    const auto mesh = layer_parts(body_and_leg(), options);
    ASSERT_TRUE(mesh.ok());
    EXPECT_NEAR(static_cast<double>(mesh->node_vertex.size()), budget, 0.05 * budget);
  }
}

struct Case {
  const char* name;
  Scene scene;
  int components;
};

std::vector<Case> joined_cases() {
  std::vector<Case> cases;
  Scene wide = body_and_leg();
  wide.parts[1] = part("leg", rectangle(80, 160, 320, 320));
  wide.joins[0].line = {{80, 160}, {320, 160}};
  cases.push_back({"the join leaves the lower part on both sides", wide, 2});
  Scene on_rim = body_and_leg();
  on_rim.parts[1] = part("leg", rectangle(100, 160, 220, 320));
  on_rim.joins[0].line = {{100, 160}, {220, 160}};
  cases.push_back({"an end on the lower outline", on_rim, 1});
  Scene crossing = body_and_leg();
  crossing.parts.push_back(part("arm", rectangle(200, 130, 380, 190)));
  crossing.joins.push_back({2, 0, {{200, 130}, {200, 190}}});
  cases.push_back({"a join that crosses another", crossing, 1});
  Scene straddling = canvas();
  straddling.parts = {part("body", rectangle(50, 100, 250, 220)),
                      part("head", rectangle(200, 60, 380, 190)),
                      part("leg", rectangle(170, 150, 240, 330))};
  straddling.joins = {{1, 0, {{200, 100}, {200, 190}}}, {2, 0, {{170, 150}, {240, 150}}}};
  cases.push_back({"a join that straddles a seam", straddling, 1});
  Scene third = body_and_leg();
  third.parts.push_back(part("patch", circle({220, 165}, 30)));
  cases.push_back({"a third outline over the join", third, 2});
  Scene behind = body_and_leg();
  behind.parts.insert(behind.parts.begin(), part("wing", circle({180, 165}, 30)));
  behind.joins[0] = {2, 1, {{180, 160}, {220, 160}}};
  cases.push_back({"a third outline behind the join", behind, 2});
  Scene handle = canvas();
  handle.parts = {part("cup", rectangle(50, 50, 200, 350))};
  Part grip = part("grip", rectangle(150, 100, 330, 300));
  grip.outline.push_back({{150, 150}, {150, 250}, {280, 250}, {280, 150}});
  grip.outline[0] = {{150, 100}, {330, 100}, {330, 300}, {150, 300},
                     {150, 250}, {280, 250}, {280, 150}, {150, 150}};
  grip.outline.resize(1);
  handle.parts.push_back(grip);
  handle.joins = {{1, 0, {{150, 100}, {150, 150}}}, {1, 0, {{150, 250}, {150, 300}}}};
  cases.push_back({"two joins of one part", handle, 1});
  Scene ear = canvas();
  ear.parts = {part("head", circle({200, 200}, 150)), part("ear", rectangle(170, 150, 230, 240))};
  ear.joins = {{1, 0, {{170, 150}, {230, 150}}}};
  cases.push_back({"an ear that never leaves the head", ear, 1});
  Scene on_seam = body_and_leg();
  on_seam.parts.push_back(part("toe", rectangle(200, 160, 240, 300)));
  on_seam.joins.push_back({2, 1, {{200, 160}, {240, 160}}});
  cases.push_back({"an end on another join, along it", on_seam, 1});
  Scene twice = body_and_leg();
  twice.parts.push_back(part("twin", rectangle(180, 160, 220, 320)));
  twice.joins.push_back({2, 0, {{180, 160}, {220, 160}}});
  cases.push_back({"the same outline and join twice", twice, 2});
  return cases;
}

TEST(LayerParts, JoinsAreManifoldHoweverPartsOverlap) {
  for (const Case& c : joined_cases())
    for (const double edge : {10.0, 5.0, 3.0}) {
      SCOPED_TRACE(std::string(c.name) + ", edge " + std::to_string(edge));
      const LayeredMesh mesh = layers_of(c.scene, edge);
      EXPECT_EQ(check_manifold(mesh).components, c.components);
    }
}

TEST(LayerParts, JoinOutsideTheLowerPartIsRefused) {
  Scene scene = body_and_leg();
  scene.joins[0].line = {{180, 320}, {220, 320}};
  const auto mesh = layer_parts(scene, {});
  ASSERT_FALSE(mesh.ok());
  EXPECT_EQ(mesh.error().code, ErrorCode::bad_input);
  EXPECT_NE(mesh.error().where.find("joins[0]"), std::string::npos);
  EXPECT_EQ(to_string(mesh.error().culprit), "joins[0]");
}

TEST(LayerParts, StopsAfterEachReportWhenCancelled) {
  const Scene scene = body_and_leg();
  int reports = 0;
  RunContext counting;
  counting.progress = [&](const char*, double) { ++reports; };
  ASSERT_TRUE(layer_parts(scene, {}, counting).ok());
  ASSERT_GT(reports, 1);
  for (int stop_after = 0; stop_after <= reports; ++stop_after) {
    std::atomic<bool> cancel = stop_after == 0;
    int left = stop_after;
    RunContext context{&cancel};
    context.progress = [&](const char*, double) { cancel = --left <= 0; };
    const auto mesh = layer_parts(scene, {}, context);
    ASSERT_FALSE(mesh.ok()) << stop_after;
    EXPECT_EQ(mesh.error().code, ErrorCode::interrupted);
  }
}

}  // namespace
}  // namespace relievo::relief

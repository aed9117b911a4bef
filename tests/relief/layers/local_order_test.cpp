#include "relief/layers/local_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/depth_optimality.h"
#include "support/enforced_pairs.h"
#include "support/mesh_checks.h"
#include "support/probe.h"
#include "support/random_scene.h"

namespace relievo::relief {
namespace {

using namespace testing;

constexpr int neck = 0;
constexpr int scarf = 1;

ReliefOptions options_for(int vertices) {
  ReliefOptions options;
  options.layers.vertex_budget = vertices;
  return options;
}

Relation relation(RelationKind kind, Point2 from, Point2 to, int upper = 1, int lower = 0) {
  return {upper, lower, kind, std::pair{from, to}};
}

/// A ring around a post: its upper strand lies behind.
Scene scarf_around_neck() {
  Scene scene = canvas();
  Part ring = part("scarf", rectangle(80, 120, 320, 280), 2);
  ring.outline.push_back({{120, 160}, {120, 240}, {280, 240}, {280, 160}});
  scene.parts = {part("neck", rectangle(150, 50, 250, 350)), ring};
  scene.relations = {relation(RelationKind::below, {140, 120}, {260, 120}),
                     relation(RelationKind::below, {260, 160}, {140, 160})};
  return scene;
}

/// A bar that comes out of a disc: its left half lies behind, its right half in front.
Scene bar_through_disc() {
  Scene scene = canvas();
  scene.parts = {part("disc", circle({200, 200}, 100)), part("bar", rectangle(50, 180, 350, 220))};
  scene.relations = {relation(RelationKind::below, {60, 180}, {200, 180}),
                     relation(RelationKind::above, {200, 180}, {340, 180}),
                     relation(RelationKind::above, {340, 220}, {200, 220}),
                     relation(RelationKind::below, {200, 220}, {60, 220})};
  return scene;
}

Error failure_of(const Scene& scene) {
  const auto relief = build_relief(scene, options_for(1500));
  EXPECT_FALSE(relief.ok());
  return relief.ok() ? Error{} : relief.error();
}

/// Expects that no part dips below one that must be behind it, and that no smaller shift does so.
void expect_optimal(const Scene& scene) {
  ReliefOptions options = options_for(1500);
  options.hidden = false;
  const Relief relief = relief_of(scene, options);
  EXPECT_EQ(inconsistency(relief.layers, false), "");
  EXPECT_EQ(relief.ordering.max_violation, 0);
  EXPECT_LE(relief.ordering.report.stationarity, 1e-12);
  EXPECT_LE(relief.ordering.report.dual, 1e-12);
  const DepthOptimality optimality =
      check_depth_optimality({relief.layers, scene, options.ordering.epsilon}, relief.inflation,
                             enforced_pairs(relief.layers), relief.ordering.h);
  EXPECT_EQ(optimality.violation, 0);
  EXPECT_LE(optimality.imbalance, 1e-12);
}

/// Counts the inequalities that keep `behind` behind `front` at base vertices in a box.
int pairs_in(const LayeredMesh& mesh, int behind, int front, Point2 min, Point2 max) {
  return static_cast<int>(
      std::count_if(mesh.constraints.begin(), mesh.constraints.end(), [&](const DepthPair& pair) {
        const Point2 p = mesh.vertices[mesh.node_vertex[pair.lower]];
        return !pair.equal && mesh.node_part[pair.lower] == behind &&
               mesh.node_part[pair.upper] == front && p.x >= min.x && p.x <= max.x &&
               p.y >= min.y && p.y <= max.y;
      }));
}

TEST(LocalOrder, ScarfGoesBehindTheNeckAndInFrontOfIt) {
  const Relief relief = relief_of(scarf_around_neck(), options_for(4000));
  const LayeredMesh& mesh = relief.layers;
  const Point2 corner{0, 0};
  const Point2 end{400, 400};
  EXPECT_GT(pairs_in(mesh, scarf, neck, corner, {400, 200}), 20);
  EXPECT_EQ(pairs_in(mesh, neck, scarf, corner, {400, 200}), 0);
  EXPECT_GT(pairs_in(mesh, neck, scarf, {0, 200}, end), 20);
  EXPECT_EQ(pairs_in(mesh, scarf, neck, {0, 200}, end), 0);
  EXPECT_EQ(relief.ordering.max_violation, 0);
  EXPECT_EQ(relief.ordering.overlap_samples, 0);
}

TEST(LocalOrder, TheFrontPartIsVisible) {
  const Relief relief = relief_of(scarf_around_neck(), options_for(4000));
  for (const double x : {160.0, 200.0, 240.0}) {
    EXPECT_EQ(probe(relief, {x, 140}).part, neck);
    EXPECT_EQ(probe(relief, {x, 260}).part, scarf);
    EXPECT_GT(probe(relief, {x, 260}).h(), probe(relief, {x, 260}, neck).h());
  }
  const Relief through = relief_of(bar_through_disc(), options_for(4000));
  EXPECT_EQ(probe(through, {150, 200}).part, 0);
  EXPECT_EQ(probe(through, {250, 200}).part, 1);
}

TEST(LocalOrder, HeightsAreOptimalUnderBothSenses) {
  expect_optimal(scarf_around_neck());
  expect_optimal(bar_through_disc());
}

TEST(LocalOrder, PartsAreEqualWhereBothSensesEnd) {
  const Relief relief = relief_of(bar_through_disc(), options_for(4000));
  const LayeredMesh& mesh = relief.layers;
  int met = 0;
  for (const DepthPair& pair : mesh.constraints) {
    const Point2 p = mesh.vertices[mesh.node_vertex[pair.lower]];
    if (p.x != 200 || (p.y != 180 && p.y != 220)) continue;
    EXPECT_TRUE(pair.equal);
    EXPECT_EQ(relief.ordering.h[pair.lower], relief.ordering.h[pair.upper]);
    ++met;
  }
  EXPECT_EQ(met, 2);
}

TEST(LocalOrder, GivesTheSameReliefWhicheverPartIsBelow) {
  const Scene scene = scarf_around_neck();
  Scene other = scene;
  std::swap(other.parts[0], other.parts[1]);  // now the neck is in front except of the lower strand
  other.relations = {relation(RelationKind::below, {250, 230}, {250, 290}),
                     relation(RelationKind::below, {150, 290}, {150, 230})};
  const Relief a = relief_of(scene, options_for(8000));
  const Relief b = relief_of(other, options_for(8000));
  for (const Point2 p : std::vector<Point2>{
           {200, 100}, {200, 140}, {200, 200}, {200, 260}, {100, 200}, {300, 200}, {170, 140}}) {
    const Probe seen = probe(a, p);
    const Probe same = probe(b, p);
    EXPECT_EQ(seen.part, 1 - same.part);
    EXPECT_NEAR(seen.h(), same.h(), 0.5) << p.x << " " << p.y;
  }
}

TEST(LocalOrder, HoldsInTheNonlinearMethodToo) {
  for (const Scene& scene : {scarf_around_neck(), bar_through_disc()}) {
    ReliefOptions options = options_for(2000);
    options.method = Method::nonlinear;
    const Relief relief = relief_of(scene, options);
    EXPECT_EQ(relief.nonlinear.status, SolveStatus::solved);
    for (const DepthPair& pair : relief.layers.constraints)
      EXPECT_LE(relief.ordering.h[pair.lower], relief.ordering.h[pair.upper] + 1e-9);
  }
}

TEST(LocalOrder, APartBehindAnotherIsBehindWhatCoversIt) {
  Scene scene = canvas();
  scene.parts = {part("body", rectangle(100, 100, 300, 300)),
                 part("shirt", rectangle(120, 80, 280, 280)),
                 part("arm", rectangle(180, 150, 380, 190), 2)};
  scene.relations = {relation(RelationKind::below, {170, 150}, {310, 150}, 2, 0),
                     relation(RelationKind::below, {310, 190}, {170, 190}, 2, 0)};
  // The end of the arm inside the body.
  scene.relations.push_back(relation(RelationKind::below, {180, 190}, {180, 150}, 2, 0));
  const Relief relief = relief_of(scene, options_for(3000));
  EXPECT_EQ(probe(relief, {230, 170}).part, 1);
  EXPECT_EQ(probe(relief, {290, 170}).part, 0);
  EXPECT_EQ(pairs_in(relief.layers, 1, 2, {0, 0}, {400, 400}), 0);
  EXPECT_EQ(relief.ordering.max_violation, 0);
  expect_optimal(scene);
}

TEST(LocalOrder, RangesTakePrecedenceOverWholeRelations) {
  Scene scene = scarf_around_neck();
  const LayeredMesh plain = relief_of(scene, options_for(1500)).layers;
  for (const size_t at : {0, 2}) {
    Scene both = scene;
    both.relations.insert(both.relations.begin() + static_cast<int>(at),
                          {scarf, neck, RelationKind::above, {}});
    const LayeredMesh mesh = relief_of(both, options_for(1500)).layers;
    EXPECT_EQ(mesh.constraints, plain.constraints);
    EXPECT_EQ(mesh.face_part, plain.face_part);
  }
}

TEST(LocalOrder, ContradictionsNameBothRelations) {
  Scene scene = scarf_around_neck();
  scene.relations.push_back(relation(RelationKind::above, {200, 120}, {300, 120}));
  const Error error = failure_of(scene);
  EXPECT_EQ(error.code, ErrorCode::contradiction);
  EXPECT_EQ(error.where, "relations[0]");
  EXPECT_EQ(to_string(error.culprit), "relations[0]");
  EXPECT_NE(error.message.find("relations[2]"), std::string::npos);
  // Outside the neck the parts do not overlap.
  scene.relations.back() = relation(RelationKind::above, {255, 120}, {300, 120});
  EXPECT_TRUE(build_relief(scene, options_for(1500)).ok());
}

TEST(LocalOrder, CyclesAtAPointAreContradictions) {
  Scene scene = canvas();
  scene.parts = {part("a", rectangle(100, 100, 300, 300)), part("b", rectangle(120, 120, 320, 280)),
                 part("c", rectangle(50, 180, 350, 220), 2)};
  scene.relations = {relation(RelationKind::below, {60, 180}, {340, 180}, 2, 0),
                     relation(RelationKind::above, {200, 180}, {340, 180}, 2, 1)};
  EXPECT_EQ(failure_of(scene).code, ErrorCode::contradiction);
  // There is none if b lies behind a there as well.
  scene.relations = {relation(RelationKind::below, {60, 180}, {340, 180}, 2, 1),
                     relation(RelationKind::above, {60, 180}, {340, 180}, 2, 0)};
  EXPECT_TRUE(build_relief(scene, options_for(1500)).ok());
}

TEST(LocalOrder, RandomScenesStaySoundWhateverIsBehind) {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = random_scene(seed);
    Random random(seed);
    for (int upper = 1; upper < static_cast<int>(scene.parts.size()); ++upper) {
      const Ring& ring = scene.parts[upper].outline[0];
      const size_t from = random.integer(0, 159);
      scene.relations.push_back(relation(RelationKind::below, ring[from],
                                         ring[(from + random.integer(20, 100)) % 160], upper,
                                         random.integer(0, upper - 1)));
    }
    const Relief relief = relief_of(scene, options_for(2000));
    EXPECT_EQ(inconsistency(relief.layers, false), "");
    EXPECT_LE(relief.ordering.max_violation, 1e-9);
    EXPECT_LE(relief.ordering.report.stationarity, 1e-12);
    EXPECT_LE(relief.ordering.report.dual, 1e-12);
  }
}

}  // namespace
}  // namespace relievo::relief

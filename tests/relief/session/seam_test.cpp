#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/mesh_checks.h"
#include "support/probe.h"
#include "support/random_limbs.h"
#include "support/regions.h"
#include "support/scenes.h"
#include "support/seams.h"

namespace relievo::relief {
namespace {

using namespace testing;

Relief build(const Scene& scene, double alpha0 = 0.1, int vertices = 20000) {
  ReliefOptions options;
  options.layers.vertex_budget = vertices;
  options.inflation.alpha0 = alpha0;
  return relief_of(scene, options);
}

TEST(Seam, HasNoKinkAcrossItsMiddle) {
  const Relief relief = build(body_and_leg());
  // One-sided slopes of second order at the seam.
  const double step = 3;
  const auto slope = [&](double side) {
    const double z0 = probe(relief, {200, 160}).h();
    const double z1 = probe(relief, {200, 160 + side * step}).h();
    const double z2 = probe(relief, {200, 160 + 2 * side * step}).h();
    return side * (4 * z1 - z2 - 3 * z0) / (2 * step);
  };
  EXPECT_LT(std::abs(slope(1) - slope(-1)), 0.02);
}

TEST(Seam, EndsAreAsHighAsTheMiddle) {
  const Relief relief = build(body_and_leg());
  const double middle = probe(relief, {200, 160}).h();
  EXPECT_GE(probe(relief, {180, 160}).h(), 0.9 * middle);
  EXPECT_GE(probe(relief, {220, 160}).h(), 0.9 * middle);
}

TEST(Seam, DirichletEndsMakeThePaperPits) {
  const Relief relief = build(body_and_leg(), 1);
  EXPECT_LT(probe(relief, {180, 160}).h(), 0.75 * probe(relief, {200, 160}).h());
}

/// The angles across joins of random limbs: median and mean of each join's median, degrees.
struct Sharpness {
  double median = 0;
  double mean = 0;
};

Sharpness sharpness_of_limbs(Method method, int vertices) {
  std::vector<double> medians;
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    ReliefOptions options;
    options.method = method;
    options.layers.vertex_budget = vertices;
    const Relief relief = relief_of(random_limbs(seed), options);
    for (const SeamChain& chain : seam_chains(relief.layers)) {
      const std::vector<double> angles = seam_angles(relief.layers, relief.ordering.h, chain);
      if (!angles.empty()) medians.push_back(angles[angles.size() / 2]);
    }
  }
  std::sort(medians.begin(), medians.end());
  const double sum = std::accumulate(medians.begin(), medians.end(), 0.0);
  return {medians[medians.size() / 2], sum / static_cast<double>(medians.size())};
}

TEST(Seam, IsNoEdgeOnRandomLimbs) {
  for (const Method method : {Method::approximate, Method::nonlinear}) {
    const Sharpness coarse = sharpness_of_limbs(method, 6000);
    const Sharpness fine = sharpness_of_limbs(method, 24000);
    EXPECT_LE(fine.median, 0.4);
    EXPECT_LE(fine.mean, 0.5);
    // The edges are half as long, those of short joins somewhat longer.
    EXPECT_LE(fine.median, 0.6 * coarse.median);
    EXPECT_LE(fine.mean, 0.6 * coarse.mean);
  }
}

TEST(Seam, IsNoEdgeWhereItIsShortOrNearARim) {
  ReliefOptions options;
  options.layers.vertex_budget = 48000;
  for (const Method method : {Method::approximate, Method::nonlinear}) {
    options.method = method;
    for (const uint64_t seed : {46, 95, 200, 244}) {
      const Relief relief = relief_of(random_limbs(seed), options);
      const std::vector<SeamChain> chains = seam_chains(relief.layers);
      ASSERT_EQ(chains.size(), 2u);
      const std::vector<double> angles = seam_angles(relief.layers, relief.ordering.h, chains[1]);
      ASSERT_FALSE(angles.empty());
      EXPECT_LE(angles[angles.size() / 2], 1) << seed;
      EXPECT_LE(angles.back(), 2.2) << seed;
    }
  }
}

TEST(Seam, HasShorterEdgesThanOutlines) {
  ReliefOptions options;
  for (const int vertices : {30000, 48000}) {
    options.layers.vertex_budget = vertices;
    for (const uint64_t seed : {46, 95}) {  // 5 px of the second join of 95 lie on the lower part
      const Relief relief = relief_of(random_limbs(seed), options);
      for (const SeamChain& chain : seam_chains(relief.layers)) {
        const double edge = chain.length.back() / static_cast<double>(chain.nodes.size() - 1);
        const double most = chain.length.back() < 10 ? 0.25 : 0.5;
        EXPECT_LE(edge, most * relief.layers.edge_length) << seed;
      }
    }
  }
}

TEST(Seam, IsSmoothWhereALimbLiesOnWhatItGrowsOutOf) {
  // Limbs on limbs, turned back so that their whole outline lies on limb and body.
  for (const uint64_t seed : {38, 121}) {
    ReliefOptions options;
    options.layers.vertex_budget = 48000;
    const Relief relief = relief_of(random_limbs(seed), options);
    const std::vector<SeamChain> chains = seam_chains(relief.layers);
    ASSERT_EQ(chains.size(), 2u);
    EXPECT_LE(seam_angles(relief.layers, relief.ordering.h, chains[1]).back(), 2) << seed;
    const JoinEnds ends = join_ends(relief.layers, relief.ordering.h, chains[1]);
    for (const double pit : ends.pits) EXPECT_LE(pit, 0.01);
    for (const double bump : ends.bumps) EXPECT_LE(bump, 0.01);
  }
}

TEST(Seam, IsSmoothWhereTwoPointsOfARoundRootAreEquallyNear) {
  ReliefOptions options;
  options.layers.vertex_budget = 48000;
  for (const uint64_t seed : {6, 67, 126}) {
    const Relief relief = relief_of(random_limbs(seed), options);
    for (const SeamChain& chain : seam_chains(relief.layers))
      EXPECT_LE(seam_angles(relief.layers, relief.ordering.h, chain).back(), 2) << seed;
  }
}

/// Counts the edges in the middle of the join that are open between visible faces.
int torn_edges(const LayeredMesh& mesh, const Join& join) {
  const std::vector<Point2> middle(join.line.begin() + 2, join.line.end() - 2);
  int torn = 0;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int face = mesh.stack_begin[t + 1] - 1;
    if (mesh.face_part[face] != join.upper) continue;
    for (int k = 0; k < 3; ++k) {
      const int other = mesh.neighbours[t][k];
      if (other < 0) continue;
      const int beyond = mesh.stack_begin[other + 1] - 1;
      const int a = mesh.faces[face][(k + 1) % 3];
      const int b = mesh.faces[face][(k + 2) % 3];
      const Point2 at =
          0.5 * (mesh.vertices[mesh.node_vertex[a]] + mesh.vertices[mesh.node_vertex[b]]);
      if (mesh.face_part[beyond] == join.upper) continue;
      if (distance_to_polyline(middle, at) > 0.5 * mesh.edge_length) continue;
      const auto& nodes = mesh.faces[beyond];
      torn += static_cast<int>(std::count(nodes.begin(), nodes.end(), a) == 0 ||
                               std::count(nodes.begin(), nodes.end(), b) == 0);
    }
  }
  return torn;
}

TEST(Seam, GrowsOutOfWhatIsSeenWhereRootsCross) {
  ReliefOptions options;
  options.layers.vertex_budget = 24000;
  for (const uint64_t seed : {43, 171, 194}) {
    const Scene scene = random_limbs(seed);
    const Relief relief = relief_of(scene, options);
    EXPECT_EQ(torn_edges(relief.layers, scene.joins[1]), 0) << seed;
    for (const SeamChain& chain : seam_chains(relief.layers)) {
      for (const double angle : seam_angles(relief.layers, relief.ordering.h, chain))
        EXPECT_LE(angle, 2) << seed;
      for (const double pit : join_ends(relief.layers, relief.ordering.h, chain).pits)
        EXPECT_LE(pit, 0.02) << seed;
    }
  }
}

TEST(Seam, HasNeitherPitsNorBumpsAtItsEnds) {
  for (const bool attach : {true, false}) {
    ReliefOptions options;
    options.layers.vertex_budget = 12000;
    options.layers.attach = attach;
    const Relief relief = relief_of(body_and_leg(), options);
    const std::vector<SeamChain> chains = seam_chains(relief.layers);
    ASSERT_EQ(chains.size(), 1u);
    const JoinEnds ends = join_ends(relief.layers, relief.ordering.h, chains[0]);
    for (const double pit : ends.pits) EXPECT_LE(pit, 0.01);
    if (!attach) continue;
    for (const double bump : ends.bumps) EXPECT_LE(bump, 0.01);
  }
}

TEST(Seam, HasPitsOnlyWhereOtherPartsForkBesideItsEnds) {
  ReliefOptions options;
  options.layers.vertex_budget = 24000;
  for (const uint64_t seed : {56, 128, 235}) {
    const Scene scene = random_limbs(seed);
    const Relief relief = relief_of(scene, options);
    double deepest = 0;
    for (const SeamChain& chain : seam_chains(relief.layers)) {
      for (const double pit : join_ends(relief.layers, relief.ordering.h, chain).pits)
        deepest = std::max(deepest, pit);
      const JoinEnds alone = join_ends_alone(scene, relief.layers, chain, options);
      ASSERT_EQ(alone.pits.size(), 2u);
      for (const double pit : alone.pits) EXPECT_LE(pit, 0.005) << seed;
    }
    EXPECT_GE(deepest, 0.1) << seed << ": the fork, which is seen";
  }
}

TEST(Seam, DirichletEndsArePitsOfTheirOwn) {
  ReliefOptions options;
  options.layers.vertex_budget = 6000;
  options.inflation.alpha0 = 1;
  const Scene scene = random_limbs(56);
  const Relief relief = relief_of(scene, options);
  const std::vector<SeamChain> chains = seam_chains(relief.layers);
  ASSERT_FALSE(chains.empty());
  const JoinEnds alone = join_ends_alone(scene, relief.layers, chains[0], options);
  ASSERT_EQ(alone.pits.size(), 2u);
  for (const double pit : alone.pits) EXPECT_GE(pit, 0.05);
}

/// A nose on a head. The head alone is a hemisphere.
Scene head_and_nose(double d = 1) {
  Scene scene = canvas();
  Ring nose;
  for (const Point2 p : circle({0, 0}, 30)) nose.push_back({200 + 1.4 * p.x, 240 + p.y});
  scene.parts = {part("head", circle({200, 200}, 150)), part("nose", nose, 4, d)};
  scene.joins = {{1, 0, {{170, 219}, {200, 210}, {230, 219}}}};
  return scene;
}

TEST(Bump, LeavesWhatIsAroundItAlone) {
  ReliefOptions options;
  options.layers.vertex_budget = 12000;
  for (const Method method : {Method::approximate, Method::nonlinear}) {
    options.method = method;
    const Relief relief = relief_of(head_and_nose(), options);
    const LayeredMesh& mesh = relief.layers;
    EXPECT_EQ(mesh.faces.size(), mesh.triangles.size()) << "it is one surface";
    for (size_t n = 0; n < mesh.node_vertex.size(); ++n) {
      const Point2 p = mesh.vertices[mesh.node_vertex[n]];
      const double r = distance(p, {200, 200});
      if (mesh.node_part[n] != 0 || r > 140) continue;
      EXPECT_NEAR(relief.ordering.h[n], std::sqrt(150 * 150 - r * r), 0.5);
    }
    EXPECT_GT(probe(relief, {200, 250}).h(), std::sqrt(150 * 150 - 50 * 50) + 10);
  }
}

TEST(Bump, GoesOnAcrossItsJoin) {
  for (const double d : {1.0, -1.0}) {
    ReliefOptions options;
    options.layers.vertex_budget = 36000;
    const Relief relief = relief_of(head_and_nose(d), options);
    const std::vector<SeamChain> chains = seam_chains(relief.layers);
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_LE(seam_angles(relief.layers, relief.ordering.h, chains[0]).back(), 1);
    const double ball = std::sqrt(150 * 150 - 50 * 50);
    EXPECT_GT(d * (probe(relief, {200, 250}).h() - ball), 10);
  }
}

TEST(Bump, ComesLooseAlongAGivenRange) {
  Scene scene = head_and_nose();
  ReliefOptions options;
  options.layers.vertex_budget = 6000;
  const double before = probe(relief_of(scene, options), {238, 245}).h();
  scene.robin = {{1, 0, {230, 219}, {200, 270}, std::nullopt, std::nullopt}};
  const double after = probe(relief_of(scene, options), {238, 245}).h();
  EXPECT_LT(after, before - 0.5) << "a longer range is lower for longer";
}

/// Returns the height at a join's end relative to that of the lower part alone. Below 1 it is a
/// pit.
double worst_pit(const Scene& scene, double alpha0) {
  Scene apart = scene;
  apart.joins.clear();
  const Relief joined = build(scene, alpha0);
  const Relief alone = build(apart, alpha0);
  double worst = 1e300;
  for (const Join& join : scene.joins)
    for (const Point2 end : {join.line.front(), join.line.back()})
      worst = std::min(worst, probe(joined, end).h() / probe(alone, end, join.lower).f);
  return worst;
}

TEST(Animal, IsSeamlessWithoutPits) {
  const auto scene = read_regions(RELIEVO_SHARED_DATA "/regions/animal.json");
  if (!scene) GTEST_SKIP() << "the shared drawings are not here";
  ASSERT_EQ(scene->joins.size(), 4u);
  EXPECT_GE(worst_pit(*scene, 0.1), 0.9);
  EXPECT_LE(worst_pit(*scene, 1), 0.7);
}

TEST(Animal, KeepsItsOrderEverywhere) {
  const auto scene = read_regions(RELIEVO_SHARED_DATA "/regions/animal.json");
  if (!scene) GTEST_SKIP() << "the shared drawings are not here";
  const Relief relief = build(*scene);
  const Manifoldness m = check_manifold(relief.layers);
  EXPECT_EQ(m.repeated_edges, 0);
  EXPECT_EQ(m.bow_ties, 0);
  EXPECT_LE(relief.ordering.max_violation, 1e-9);
  EXPECT_LE(relief.ordering.overlap_worst, 0.5);
}

}  // namespace
}  // namespace relievo::relief

#include "relief/ordering/order_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "relief/inflation/inflate.h"
#include "support/solve_once.h"
#include "support/stacked_parts.h"

namespace relievo::relief {
namespace {

using testing::add_outline_pairs;
using testing::in_box;
using testing::in_disc;
using testing::node_at;
using testing::scene_of;

Inflation inflated(const LayeredMesh& mesh, const Scene& scene) {
  const Result<Inflation> result = inflate(mesh, scene, {});
  EXPECT_TRUE(result) << to_string(result.error());
  return *result;
}

Ordering ordered(const LayeredMesh& mesh, const Inflation& inflation, const Scene& scene,
                 const OrderingOptions& options = {}) {
  const Result<Ordering> result = order_depth(mesh, inflation, scene, options);
  EXPECT_TRUE(result) << to_string(result.error());
  return *result;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

TEST(OrderDepth, LeavesUnconstrainedPartsWhereTheyAre) {
  LayeredMesh mesh = testing::scattered_discs(4, 40);
  mesh.constraints.clear();
  const Scene scene = scene_of(mesh);
  const Inflation inflation = inflated(mesh, scene);
  const Ordering ordering = ordered(mesh, inflation, scene);
  for (size_t n = 0; n < ordering.h.size(); ++n) {
    EXPECT_EQ(ordering.h[n], std::sqrt(inflation.u[n]));
    EXPECT_EQ(ordering.g[n], 0);
    EXPECT_EQ(ordering.grad_g[n], Point2{});
  }
  EXPECT_EQ(ordering.report.energy, 0);
}

TEST(OrderDepth, SharesTheShiftBetweenTiedParts) {
  const testing::Cover all = [](int, Point2) { return true; };
  LayeredMesh mesh = stack_parts(testing::jittered(testing::grid_mesh(6, 5, 10), 2), {all, all});
  Inflation inflation;
  for (size_t n = 0; n < mesh.node_vertex.size(); ++n) {
    const Point2 p = mesh.vertices[mesh.node_vertex[n]];
    const double f = mesh.node_part[n] == 0 ? 0 : 0.5 * p.x - 0.25 * p.y;
    inflation.u.push_back(f * std::abs(f));
    if (mesh.node_part[n] == 1)
      mesh.constraints.push_back(
          {node_at(mesh, 0, mesh.node_vertex[n]), static_cast<int>(n), true});
  }
  const Ordering ordering = ordered(mesh, inflation, scene_of(mesh));
  EXPECT_EQ(ordering.equalities, static_cast<int>(mesh.vertices.size()));
  EXPECT_EQ(ordering.max_violation, 0);
  for (size_t n = 0; n < ordering.h.size(); ++n) {
    const Point2 p = mesh.vertices[mesh.node_vertex[n]];
    const double sign = mesh.node_part[n] == 0 ? 1 : -1;
    EXPECT_NEAR(ordering.h[n], 0.25 * p.x - 0.125 * p.y, 1e-9);
    EXPECT_NEAR(ordering.g[n], sign * (0.25 * p.x - 0.125 * p.y), 1e-9);
    EXPECT_LE(norm(ordering.grad_g[n] - sign * Point2{0.25, -0.125}), 1e-9);
  }
}

TEST(OrderDepth, PutsASmallDiscOnALargeOne) {
  LayeredMesh mesh = stack_parts(testing::grid_mesh(40, 40, 10),
                                 {in_disc({200, 200}, 180), in_disc({180, 210}, 60)});
  add_outline_pairs(mesh);
  const Scene scene = scene_of(mesh);
  const Ordering ordering = ordered(mesh, inflated(mesh, scene), scene);
  EXPECT_GE(ordering.report.active, 1);
  EXPECT_LT(ordering.report.active, ordering.inequalities);
  EXPECT_EQ(ordering.max_violation, 0);
  for (const DepthPair& pair : mesh.constraints)
    EXPECT_GE(ordering.h[pair.upper], ordering.h[pair.lower]);
  const int centre = 21 * 41 + 18;
  EXPECT_GT(ordering.h[node_at(mesh, 1, centre)], ordering.h[node_at(mesh, 0, centre)] + 20);
}

TEST(OrderDepth, FindsTheSameHeightsFromBothStarts) {
  const LayeredMesh mesh = testing::scattered_discs(12, 25);
  const Scene scene = scene_of(mesh);
  const Inflation inflation = inflated(mesh, scene);
  OrderingOptions options;
  const Ordering none = ordered(mesh, inflation, scene, options);
  options.start_active = true;
  const Ordering all = ordered(mesh, inflation, scene, options);
  EXPECT_LE(largest_difference(none.h, all.h), 1e-7);
  EXPECT_EQ(none.report.active, all.report.active);
}

TEST(OrderDepth, OrdersPilesOfUnjoinedParts) {
  // Many loose parts on top of each other defeat plain block pivoting.
  const LayeredMesh mesh = testing::scattered_discs(30, 25);
  const Scene scene = scene_of(mesh);
  const Inflation inflation = inflated(mesh, scene);
  OrderingOptions options;
  const Ordering none = ordered(mesh, inflation, scene, options);
  EXPECT_GT(none.report.safeguard_steps, 0);
  EXPECT_LE(none.report.stationarity, 1e-12);
  EXPECT_LE(none.report.dual, 1e-12);
  EXPECT_EQ(none.max_violation, 0);
  options.start_active = true;
  EXPECT_LE(largest_difference(none.h, ordered(mesh, inflation, scene, options).h), 1e-6);
}

TEST(OrderDepth, DoesNotDependOnTheSizeOfTheDrawing) {
  const LayeredMesh mesh = testing::scattered_discs(8, 30);
  const Scene scene = scene_of(mesh);
  const Ordering ordering = ordered(mesh, inflated(mesh, scene), scene);
  for (const double factor : {0.5, 2.0, 3.7}) {
    LayeredMesh scaled = mesh;
    for (Point2& p : scaled.vertices) p = factor * p;
    const Ordering other = ordered(scaled, inflated(scaled, scene), scene);
    for (size_t n = 0; n < ordering.h.size(); ++n)
      EXPECT_NEAR(other.h[n], factor * ordering.h[n], 1e-9 * factor * 1000);
  }
}

TEST(OrderDepth, HardlyDependsOnEpsilon) {
  const LayeredMesh mesh = testing::scattered_discs(12, 25);
  const Scene scene = scene_of(mesh);
  const Inflation inflation = inflated(mesh, scene);
  OrderingOptions options;
  const Ordering ordering = ordered(mesh, inflation, scene, options);
  options.epsilon /= 2;
  EXPECT_LT(largest_difference(ordered(mesh, inflation, scene, options).h, ordering.h), 0.1);
}

TEST(OrderDepth, DoesNotDependOnTheOrderOfIndependentParts) {
  const testing::PlanarMesh base = testing::grid_mesh(40, 40, 10);
  const std::vector<testing::Cover> small = {in_disc({120, 120}, 55), in_disc({270, 130}, 70),
                                             in_disc({200, 280}, 80)};
  const auto solve = [&](const std::vector<int>& order) {
    std::vector<testing::Cover> parts = {in_disc({200, 200}, 185)};
    for (const int i : order) parts.push_back(small[i]);
    LayeredMesh mesh = stack_parts(base, parts);
    add_outline_pairs(mesh);
    const Scene scene = scene_of(mesh);
    const Ordering ordering = ordered(mesh, inflated(mesh, scene), scene);
    std::vector<double> heights(4 * mesh.vertices.size(), 0);
    for (size_t n = 0; n < ordering.h.size(); ++n) {
      const int part = mesh.node_part[n] == 0 ? 0 : 1 + order[mesh.node_part[n] - 1];
      heights[4 * mesh.node_vertex[n] + part] = ordering.h[n];
    }
    return heights;
  };
  const std::vector<double> heights = solve({0, 1, 2});
  EXPECT_LE(largest_difference(solve({2, 0, 1}), heights), 1e-7);
  EXPECT_LE(largest_difference(solve({1, 2, 0}), heights), 1e-7);
}

TEST(OrderDepth, LeavesADentBelowWhatItCovers) {
  LayeredMesh mesh = stack_parts(testing::grid_mesh(40, 40, 10),
                                 {in_disc({200, 200}, 180), in_disc({200, 200}, 60)});
  add_outline_pairs(mesh);
  for (DepthPair& pair : mesh.constraints) pair.equal = true;
  Scene scene = scene_of(mesh);
  scene.parts[1].d = -1;
  const Ordering ordering = ordered(mesh, inflated(mesh, scene), scene);
  const int centre = 20 * 41 + 20;
  EXPECT_LT(ordering.h[node_at(mesh, 1, centre)], ordering.h[node_at(mesh, 0, centre)] - 40);
}

TEST(OrderDepth, OrdersJoinedParts) {
  LayeredMesh mesh = stack_parts(testing::grid_mesh(50, 45, 4),
                                 {in_box({0, 0}, {200, 120}), in_box({80, 80}, {120, 180})});
  testing::join_parts(mesh, 1, 0, [](Point2 p) { return p.y == 80 && p.x >= 80 && p.x <= 120; });
  add_outline_pairs(mesh);
  const Scene scene = scene_of(mesh);
  const Ordering ordering = ordered(mesh, inflated(mesh, scene), scene);
  EXPECT_EQ(ordering.max_violation, 0);
}

TEST(OrderDepth, OrdersADiamondByParts) {
  const testing::Cover all = [](int, Point2) { return true; };
  LayeredMesh mesh = stack_parts(testing::grid_mesh(4, 4, 10), {all, all, all, all});
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    const auto pair = [&](int lower, int upper) {
      return DepthPair{node_at(mesh, lower, v), node_at(mesh, upper, v), false};
    };
    mesh.constraints.insert(mesh.constraints.end(),
                            {pair(0, 1), pair(0, 2), pair(1, 3), pair(2, 3)});
  }
  Scene scene = scene_of(mesh);
  for (int p = 0; p < 4; ++p) scene.parts[p].c = 8 - 2 * p;
  const Ordering ordering = ordered(mesh, inflated(mesh, scene), scene);
  EXPECT_EQ(ordering.inequalities, 3 * static_cast<int>(mesh.vertices.size()));
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v)
    for (int p = 0; p < 3; ++p)
      EXPECT_LE(ordering.h[node_at(mesh, p, v)], ordering.h[node_at(mesh, p + 1, v)]);
}

TEST(OrderDepth, RefusesOptionsOutOfRange) {
  const LayeredMesh mesh = testing::scattered_discs(2, 40);
  const Scene scene = scene_of(mesh);
  const Inflation inflation = inflated(mesh, scene);
  for (const OrderingOptions& options :
       {OrderingOptions{0, false}, OrderingOptions{std::nan(""), false}}) {
    const Result<Ordering> result = order_depth(mesh, inflation, scene, options);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::usage);
  }
}

TEST(OrderDepth, StopsWhenCancelled) {
  const LayeredMesh mesh = testing::scattered_discs(2, 40);
  const Scene scene = scene_of(mesh);
  const Inflation inflation = inflated(mesh, scene);
  const std::atomic<bool> cancel = true;
  const Result<Ordering> result = order_depth(mesh, inflation, scene, {}, RunContext{&cancel, {}});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace relievo::relief

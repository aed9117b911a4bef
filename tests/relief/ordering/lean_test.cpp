#include <gtest/gtest.h>

#include <cmath>

#include "relief/inflation/inflate.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/order_depth.h"
#include "relief/ordering/shift_metric.h"
#include "support/shift_cost.h"
#include "support/solve_once.h"
#include "support/stacked_parts.h"

namespace relievo::relief {
namespace {

using testing::in_box;
using testing::ShiftCost;

Ordering ordered(const LayeredMesh& mesh, const Scene& scene) {
  const Result<Inflation> inflation = inflate(mesh, scene, {});
  EXPECT_TRUE(inflation) << to_string(inflation.error());
  OrderingOptions options;
  options.straight_limbs = false;  // leans alone
  const Result<Ordering> ordering = order_depth(mesh, *inflation, scene, options);
  EXPECT_TRUE(ordering) << to_string(ordering.error());
  return *ordering;
}

Eigen::VectorXd shift_in_units(const LayeredMesh& mesh, const Ordering& ordering) {
  Eigen::VectorXd g(static_cast<Eigen::Index>(ordering.g.size()));
  for (Eigen::Index n = 0; n < g.size(); ++n) g[n] = scene_scale(mesh) * ordering.g[n];
  return g;
}

Scene leaning_scene(const LayeredMesh& mesh) {
  Scene scene = testing::scene_of(mesh);
  for (size_t part = 0; part < scene.parts.size(); ++part) {
    const double angle = 0.7 * static_cast<double>(part);
    scene.parts[part].lean = 0.3 * Point2{std::cos(angle), std::sin(angle)};
  }
  return scene;
}

/// A body and a leg in one surface.
LayeredMesh joined_boxes() {
  LayeredMesh mesh = stack_parts(testing::jittered(testing::grid_mesh(50, 45, 4), 0),
                                 {in_box({0, 0}, {200, 120}), in_box({80, 80}, {120, 180})});
  testing::join_parts(mesh, 1, 0, [](Point2 p) { return p.y == 80 && p.x >= 80 && p.x <= 120; });
  return mesh;
}

/// Returns the centroid of a part's faces, px.
Point2 middle_of(const LayeredMesh& mesh, int part) {
  Point2 sum;
  double weight = 0;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.face_part[f] != part) continue;
    const auto corner = [&](int k) { return mesh.vertices[mesh.node_vertex[mesh.faces[f][k]]]; };
    const double area = cross(corner(1) - corner(0), corner(2) - corner(0));
    sum = sum + area / 3 * (corner(0) + corner(1) + corner(2));
    weight += area;
  }
  return 1 / weight * sum;
}

TEST(Lean, UprightPartsPullNowhere) {
  const LayeredMesh mesh = testing::scattered_discs(6, 25);
  ShiftMetric metric = make_shift_metric(discretise(mesh), 1e-4);
  set_slopes(mesh, testing::scene_of(mesh), 1e-4, metric);
  EXPECT_EQ(metric.constant, 0);
  ASSERT_EQ(metric.b.size(), static_cast<Eigen::Index>(mesh.node_vertex.size()));
  EXPECT_TRUE((metric.b.array() == 0).all());
}

TEST(Lean, APartOfItsOwnIsItsInflationAndItsSlope) {
  const LayeredMesh mesh =
      stack_parts(testing::jittered(testing::grid_mesh(50, 50, 20), 5),
                  {testing::in_disc({250, 250}, 180), testing::in_disc({700, 300}, 120),
                   in_box({300, 600}, {900, 900})});
  const Scene scene = leaning_scene(mesh);
  const Ordering ordering = ordered(mesh, scene);
  for (size_t n = 0; n < ordering.g.size(); ++n) {
    const int part = mesh.node_part[n];
    const Point2 lean = scene.parts[part].lean;
    const Point2 at = mesh.vertices[mesh.node_vertex[n]] - middle_of(mesh, part);
    // Only epsilon fixes the height of the whole part, on a canvas of 1000 px, so round-off is
    // large.
    EXPECT_NEAR(ordering.g[n], dot(lean, at), 1e-7);
    EXPECT_LE(norm(ordering.grad_g[n] - lean), 1e-9);
  }
  EXPECT_NEAR(ordering.report.energy, 0, 1e-12);
}

TEST(Lean, JoinedPartsOfOneLeanAreOneSlope) {
  const LayeredMesh mesh = joined_boxes();
  Scene scene = testing::scene_of(mesh);
  for (Part& part : scene.parts) part.lean = {0.25, -0.5};
  const Ordering ordering = ordered(mesh, scene);
  for (const Point2 slope : ordering.grad_g) EXPECT_LE(norm(slope - Point2{0.25, -0.5}), 1e-7);
}

TEST(Lean, TheShiftIsStationaryForTheStatedCost) {
  const LayeredMesh mesh = joined_boxes();
  const Scene scene = leaning_scene(mesh);
  const ShiftCost cost{mesh, scene, OrderingOptions().epsilon};
  const Eigen::VectorXd g = shift_in_units(mesh, ordered(mesh, scene));
  EXPECT_LE(cost.slope(g).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_GT(cost.slope(0 * g).lpNorm<Eigen::Infinity>(), 1e-3);
}

TEST(Lean, TheReportedEnergyIsTheCost) {
  for (const LayeredMesh& mesh : {joined_boxes(), testing::scattered_discs(6, 25)}) {
    const Scene scene = leaning_scene(mesh);
    const Ordering ordering = ordered(mesh, scene);
    const double cost =
        ShiftCost{mesh, scene, OrderingOptions().epsilon}(shift_in_units(mesh, ordering));
    EXPECT_GT(cost, 1e-6);
    EXPECT_NEAR(ordering.report.energy, cost, 1e-13);
    EXPECT_EQ(ordering.max_violation, 0);
  }
}

TEST(Lean, LoosePartsGoAlongWithWhatTheyLieOn) {
  // Two upright boxes, one in front of a board that leans, one behind it.
  const LayeredMesh mesh = stack_parts(
      testing::grid_mesh(60, 20, 5),
      {in_box({260, 40}, {280, 60}), in_box({0, 0}, {300, 100}), in_box({20, 40}, {40, 60})});
  Scene scene = testing::scene_of(mesh);
  scene.parts[1].lean = {0.5, 0};
  const Ordering ordering = ordered(mesh, scene);
  for (size_t n = 0; n < ordering.g.size(); ++n) {
    const double x = mesh.vertices[mesh.node_vertex[n]].x;
    const int part = mesh.node_part[n];
    const double along = part == 0 ? 270 : part == 1 ? x : 30;
    const double first = mesh.vertices[mesh.node_vertex[0]].x;
    const double of_first = mesh.node_part[0] == 0 ? 270 : mesh.node_part[0] == 1 ? first : 30;
    EXPECT_NEAR(ordering.g[n] - ordering.g[0], 0.5 * (along - of_first), 1e-3) << part;
  }
}

}  // namespace
}  // namespace relievo::relief

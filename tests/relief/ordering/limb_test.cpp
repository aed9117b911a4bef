#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflate.h"
#include "relief/layers/layer_parts.h"
#include "relief/ordering/limb_rise.h"
#include "relief/ordering/order_depth.h"
#include "support/scenes.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// A body and a leg that hangs from its middle, `by` times as large.
Scene body_and_limb(double by = 1) {
  Scene scene;
  scene.width = scene.height = by * 400;
  scene.parts = {testing::part("body", testing::rectangle(by * 20, by * 60, by * 380, by * 200)),
                 testing::part("leg", testing::rectangle(by * 165, by * 130, by * 235, by * 380))};
  scene.joins = {{1, 0, {{by * 165, by * 130}, {by * 235, by * 130}}}};
  return scene;
}

/// A scene as far as its shift.
struct Solved {
  LayeredMesh mesh;
  Inflation inflation;
  Ordering ordering;

  Point2 at(size_t n) const { return mesh.vertices[mesh.node_vertex[n]]; }

  /// The largest height of the leg between two rows.
  double crest(double from, double to) const {
    double top = 0;
    for (size_t n = 0; n < ordering.h.size(); ++n)
      if (mesh.node_part[n] == 1 && at(n).y >= from && at(n).y <= to)
        top = std::max(top, ordering.h[n]);
    return top;
  }
};

Solved solved(const Scene& scene, bool straight_limbs) {
  LayerOptions options;
  options.vertex_budget = 3000;
  Result<LayeredMesh> mesh = layer_parts(scene, options);
  EXPECT_TRUE(mesh) << to_string(mesh.error());
  Result<Inflation> inflation = inflate(*mesh, scene, {});
  EXPECT_TRUE(inflation) << to_string(inflation.error());
  OrderingOptions ordering;
  ordering.wanted.straight_limbs = straight_limbs;
  Result<Ordering> order = order_depth(*mesh, *inflation, scene, ordering);
  EXPECT_TRUE(order) << to_string(order.error());
  return {std::move(*mesh), std::move(*inflation), std::move(*order)};
}

VectorXd shift_of(const Solved& relief, const Scene& scene) {
  const Discretisation discretisation = discretise(relief.mesh);
  return limb_rise({relief.mesh, discretisation, scene}, relief.inflation);
}

TEST(Limb, KeepsTheHeightOfItsRoot) {
  const Scene scene = body_and_limb();
  const Solved straight = solved(scene, true);
  const Solved back = solved(scene, false);
  EXPECT_LT(back.crest(300, 340), 0.65 * back.crest(130, 150));
  for (double y = 150; y < 350; y += 20) {
    EXPECT_GT(straight.crest(y, y + 20), 0.9 * straight.crest(130, 150)) << y;
    EXPECT_LT(straight.crest(y, y + 20), 1.1 * straight.crest(130, 150)) << y;
  }
  EXPECT_EQ(straight.ordering.max_violation, 0);
}

TEST(Limb, FarFromItsRootItIsMovedAsAWhole) {
  const Scene scene = body_and_limb();
  const Solved relief = solved(scene, true);
  const double height = relief.crest(300, 340);
  for (size_t n = 0; n < relief.ordering.g.size(); ++n) {
    if (relief.mesh.node_part[n] != 1 || relief.at(n).y < 300) continue;
    EXPECT_NEAR(relief.ordering.grad_g[n].x, 0, 0.02);
    EXPECT_NEAR(relief.ordering.grad_g[n].y, 0, 0.02);
    EXPECT_GT(relief.ordering.g[n], 0.25 * height);
  }
}

TEST(Limb, TakesAlongWhatGrowsOutOfIt) {
  Scene scene = body_and_limb();
  scene.parts.push_back(testing::part("foot", testing::rectangle(190, 330, 320, 370)));
  scene.joins.push_back({2, 1, {{190, 330}, {190, 370}}});
  const Solved relief = solved(scene, true);
  double leg = 0;
  double foot = 0;
  for (size_t n = 0; n < relief.ordering.g.size(); ++n) {
    if (relief.mesh.node_part[n] == 1 && relief.at(n).y > 310)
      leg = std::max(leg, relief.ordering.g[n]);
    if (relief.mesh.node_part[n] == 2 && relief.at(n).x > 290)
      foot = std::max(foot, relief.ordering.g[n]);
  }
  EXPECT_GT(leg, 10);
  EXPECT_GT(foot, 0.9 * leg);
}

TEST(Limb, WithALeanOfItsOwnLeansAsItsAuthorSays) {
  Scene scene = body_and_limb();
  scene.parts[1].lean = {0, 0.1};
  EXPECT_EQ(solved(scene, true).ordering.h, solved(scene, false).ordering.h);
}

TEST(Limb, IsWantedNowhereElse) {
  const Scene scene = body_and_limb();
  const Solved relief = solved(scene, true);
  const VectorXd shift = shift_of(relief, scene);
  for (size_t n = 0; n < relief.ordering.g.size(); ++n) {
    if (relief.mesh.node_part[n] == 0) {
      EXPECT_EQ(shift[static_cast<Eigen::Index>(n)], 0);
    }
  }
  EXPECT_GT(shift.maxCoeff(), 0);
  EXPECT_EQ(shift.size(), static_cast<Eigen::Index>(relief.mesh.node_vertex.size()));
}

TEST(Limb, WhatIsLooseOrShortOrNoThinnerIsNone) {
  Scene loose = body_and_limb();
  loose.joins.clear();
  Scene lump = body_and_limb();
  lump.joins[0].line = {{165, 140}, {235, 140}};
  lump.parts[1] = testing::part("lump", testing::rectangle(165, 140, 235, 205));
  Scene head = testing::canvas();
  head.parts = {testing::part("neck", testing::rectangle(150, 200, 250, 390)),
                testing::part("head", testing::circle({200, 150}, 120))};
  head.joins = {{1, 0, {{150, 259}, {250, 259}}}};
  for (const Scene& scene : {loose, lump, head}) {
    const Solved with = solved(scene, true);
    EXPECT_TRUE(shift_of(with, scene).isZero(0)) << scene.parts[1].id;
    EXPECT_EQ(with.ordering.h, solved(scene, false).ordering.h) << scene.parts[1].id;
  }
}

TEST(Limb, GrowsWithTheDrawingAndHasNoName) {
  Scene scene = body_and_limb();
  const Solved once = solved(scene, true);
  const Solved twice = solved(body_and_limb(2), true);
  for (Part& part : scene.parts) part.id += "-renamed";
  const Solved renamed = solved(scene, true);
  ASSERT_EQ(once.ordering.h.size(), twice.ordering.h.size());
  for (size_t n = 0; n < once.ordering.h.size(); ++n)
    EXPECT_NEAR(2 * once.ordering.h[n], twice.ordering.h[n], 1e-6);
  EXPECT_EQ(once.ordering.h, renamed.ordering.h);
}

TEST(Limb, OfAHollowPartIsItsMirrorImage) {
  Scene scene = body_and_limb();
  const Solved raised = solved(scene, true);
  const VectorXd up = shift_of(raised, scene);
  for (Part& part : scene.parts) part.d = -1;
  const Result<Inflation> sunk = inflate(raised.mesh, scene, {});
  ASSERT_TRUE(sunk);
  const VectorXd down = limb_rise({raised.mesh, discretise(raised.mesh), scene}, *sunk);
  EXPECT_LE((up + down).lpNorm<Eigen::Infinity>(), 1e-9);
}

TEST(Limb, EveryShiftCostsWhatItsDifferenceDid) {
  const Scene scene = body_and_limb();
  const Solved relief = solved(scene, true);
  ShiftMetric metric = make_shift_metric(discretise(relief.mesh), 1e-4);
  const VectorXd wanted = shift_of(relief, scene);
  const VectorXd g = VectorXd::LinSpaced(wanted.size(), -1, 2);
  const double before = (g - wanted).dot(metric.A * (g - wanted));
  add_wanted(wanted, metric);
  const double cost = g.dot(metric.A * g - metric.lean.pull) + metric.lean.rest(g);
  EXPECT_NEAR(cost, before, 1e-9 * before);
}

}  // namespace
}  // namespace relievo

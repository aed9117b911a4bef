#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "relief/inflation/inflate.h"
#include "relief/ordering/limb_rise.h"
#include "support/scenes.h"
#include "support/shifted_scene.h"
#include "support/solve_once.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;
using testing::shifted;
using testing::ShiftedScene;

/// A body and a leg that hangs from its middle, `by` times as large.
Scene body_and_limb(double by = 1) {
  Scene scene;
  scene.width = scene.height = by * 400;
  scene.parts = {testing::part("body", testing::rectangle(by * 20, by * 60, by * 380, by * 200)),
                 testing::part("leg", testing::rectangle(by * 165, by * 130, by * 235, by * 380))};
  scene.joins = {{1, 0, {{by * 165, by * 130}, {by * 235, by * 130}}}};
  return scene;
}

ShiftedScene solved(const Scene& scene, bool straight_limbs) {
  OrderingOptions options;
  options.straight_limbs = straight_limbs;
  return shifted(scene, options);
}

/// Returns the largest height of the leg between two rows.
double crest(const ShiftedScene& relief, double from, double to) {
  double top = 0;
  for (size_t n = 0; n < relief.ordering.h.size(); ++n)
    if (relief.mesh.node_part[n] == 1 && relief.at(n).y >= from && relief.at(n).y <= to)
      top = std::max(top, relief.ordering.h[n]);
  return top;
}

VectorXd shift_of(const ShiftedScene& relief, const Scene& scene) {
  return limb_rise({relief.mesh, relief.discretisation, scene}, relief.inflation);
}

TEST(Limb, KeepsTheHeightOfItsRoot) {
  const Scene scene = body_and_limb();
  const ShiftedScene straight = solved(scene, true);
  const ShiftedScene back = solved(scene, false);
  EXPECT_LT(crest(back, 300, 340), 0.65 * crest(back, 130, 150));
  for (double y = 150; y < 350; y += 20) {
    EXPECT_GT(crest(straight, y, y + 20), 0.9 * crest(straight, 130, 150)) << y;
    EXPECT_LT(crest(straight, y, y + 20), 1.1 * crest(straight, 130, 150)) << y;
  }
  EXPECT_EQ(straight.ordering.max_violation, 0);
}

TEST(Limb, FarFromItsRootItIsMovedAsAWhole) {
  const Scene scene = body_and_limb();
  const ShiftedScene relief = solved(scene, true);
  const double height = crest(relief, 300, 340);
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
  const ShiftedScene relief = solved(scene, true);
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
  const ShiftedScene relief = solved(scene, true);
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
    const ShiftedScene with = solved(scene, true);
    EXPECT_TRUE(shift_of(with, scene).isZero(0)) << scene.parts[1].id;
    EXPECT_EQ(with.ordering.h, solved(scene, false).ordering.h) << scene.parts[1].id;
  }
}

TEST(Limb, GrowsWithTheDrawingAndHasNoName) {
  Scene scene = body_and_limb();
  const ShiftedScene once = solved(scene, true);
  const ShiftedScene twice = solved(body_and_limb(2), true);
  for (Part& part : scene.parts) part.id += "-renamed";
  const ShiftedScene renamed = solved(scene, true);
  ASSERT_EQ(once.ordering.h.size(), twice.ordering.h.size());
  for (size_t n = 0; n < once.ordering.h.size(); ++n)
    EXPECT_NEAR(2 * once.ordering.h[n], twice.ordering.h[n], 1e-6);
  EXPECT_EQ(once.ordering.h, renamed.ordering.h);
}

TEST(Limb, OfAHollowPartIsItsMirrorImage) {
  Scene scene = body_and_limb();
  const ShiftedScene raised = solved(scene, true);
  const VectorXd up = shift_of(raised, scene);
  for (Part& part : scene.parts) part.d = -1;
  const Result<Inflation> sunk = inflate(raised.mesh, scene, {});
  ASSERT_TRUE(sunk);
  const VectorXd down = limb_rise({raised.mesh, raised.discretisation, scene}, *sunk);
  EXPECT_LE((up + down).lpNorm<Eigen::Infinity>(), 1e-9);
}

TEST(Limb, EveryShiftCostsWhatItsDifferenceDid) {
  const Scene scene = body_and_limb();
  const ShiftedScene relief = solved(scene, true);
  ShiftMetric metric = make_shift_metric(relief.discretisation, 1e-4);
  const VectorXd wanted = shift_of(relief, scene);
  const VectorXd g = VectorXd::LinSpaced(wanted.size(), -1, 2);
  const double before = (g - wanted).dot(metric.A * (g - wanted));
  add_wanted(wanted, metric);
  const double cost = g.dot(metric.A * g - metric.b) + metric.rest(g);
  EXPECT_NEAR(cost, before, 1e-9 * before);
}

}  // namespace
}  // namespace relievo::relief

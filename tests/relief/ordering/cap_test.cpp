#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "relief/ordering/cap_rise.h"
#include "support/scenes.h"
#include "support/shifted_scene.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using testing::shifted;
using testing::ShiftedScene;

constexpr WantedShifts loose_caps = {true, false};

/// A hat on the upper half of a head, `by` times as large.
Scene head_and_hat(double by = 1) {
  Scene scene;
  scene.width = scene.height = by * 400;
  scene.parts = {testing::part("head", testing::circle({by * 200, by * 250}, by * 120)),
                 testing::part("hat", testing::rectangle(by * 60, by * 60, by * 340, by * 220))};
  scene.relations = {{1, 0, RelationKind::equal, std::nullopt}};
  return scene;
}

ShiftMetric metric_of(const ShiftedScene& relief) {
  return make_shift_metric(relief.discretisation, OrderingOptions().epsilon);
}

VectorXd wanted_of(const ShiftedScene& relief, const Scene& scene) {
  const ShiftMetric metric = metric_of(relief);
  return cap_rise(find_caps(relief.mesh, relief.discretisation, scene, metric.A), relief.inflation,
                  metric.scale);
}

/// The farthest that the hat's outline beside and above the head is from the drawing plane.
double rim_height(const ShiftedScene& relief) {
  double most = 0;
  for (size_t n = 0; n < relief.ordering.h.size(); ++n) {
    const bool is_rim =
        relief.mesh.node_part[n] == 1 && relief.mesh.node_role[n] == NodeRole::outline;
    if (is_rim && distance(relief.at(n), {200, 250}) > 121)
      most = std::max(most, std::abs(relief.ordering.h[n]));
  }
  return most;
}

TEST(Cap, ClosesRoundWhatItLiesOn) {
  const ShiftedScene closed = shifted(head_and_hat());
  const ShiftedScene loose = shifted(head_and_hat(), loose_caps);
  const double top = *std::max_element(loose.ordering.h.begin(), loose.ordering.h.end());
  EXPECT_GT(rim_height(loose), 0.25 * top);
  EXPECT_LT(rim_height(closed), 0.02 * top);
  EXPECT_EQ(closed.ordering.max_violation, 0);
}

TEST(Cap, IsAsFarForwardAsTheHeadWhereItCrossesThat) {
  const ShiftedScene relief = shifted(head_and_hat());
  size_t crossing = 0;
  for (const DepthPair& pair : relief.mesh.constraints) {
    if (!pair.equal || relief.at(pair.upper).y < 219) continue;
    ++crossing;
    EXPECT_NEAR(relief.ordering.h[pair.upper], relief.ordering.h[pair.lower], 1e-9);
  }
  EXPECT_GT(crossing, 10U);
}

TEST(Cap, IsASoapFilmBetween) {
  const ShiftedScene relief = shifted(head_and_hat());
  const VectorXd wanted = wanted_of(relief, head_and_hat());
  const VectorXd force = metric_of(relief).A * wanted;
  double within = 0;
  double along = 0;
  for (size_t n = 0; n < relief.mesh.node_part.size(); ++n) {
    if (relief.mesh.node_part[n] != 1) {
      EXPECT_EQ(wanted[static_cast<Index>(n)], 0);
      continue;
    }
    double& most = relief.mesh.node_role[n] == NodeRole::interior ? within : along;
    most = std::max(most, std::abs(force[static_cast<Index>(n)]));
  }
  EXPECT_GT(along, 1e-3);
  EXPECT_LT(within, 1e-12);
}

TEST(Cap, TakesAlongWhatGrowsOutOfIt) {
  Scene scene = head_and_hat();
  scene.parts.push_back(testing::part("feather", testing::rectangle(180, 20, 220, 150)));
  scene.joins = {{2, 1, {{180, 150}, {220, 150}}}};
  const ShiftedScene relief = shifted(scene);
  const VectorXd wanted = wanted_of(relief, scene);
  double least = 1e9;
  double most = 0;
  for (size_t n = 0; n < relief.mesh.node_part.size(); ++n) {
    if (relief.mesh.node_part[n] != 2 || relief.at(n).y > 55) continue;
    least = std::min(least, wanted[static_cast<Index>(n)]);
    most = std::max(most, wanted[static_cast<Index>(n)]);
  }
  EXPECT_GT(least, 0);
  EXPECT_LT(most, 1.3 * least);
}

TEST(Cap, IsNoneWhereItGrowsLeansCrossesOrLiesWithin) {
  Scene leaning = head_and_hat();
  leaning.parts[1].lean = {0, 0.1};
  Scene above = head_and_hat();
  above.relations.clear();
  Scene grown = head_and_hat();
  grown.relations.clear();
  grown.joins = {{1, 0, {{120, 220}, {280, 220}}}};
  Scene sword = head_and_hat();
  sword.parts[1] = testing::part("sword", testing::rectangle(20, 240, 380, 260));
  Scene badge = head_and_hat();
  badge.parts[1] = testing::part("badge", testing::circle({200, 250}, 40));
  for (const Scene& scene : {leaning, above, grown, sword, badge}) {
    const ShiftedScene relief = shifted(scene);
    EXPECT_TRUE(wanted_of(relief, scene).isZero(0)) << scene.parts[1].id;
    EXPECT_EQ(relief.ordering.h, shifted(scene, loose_caps).ordering.h) << scene.parts[1].id;
  }
}

TEST(Cap, GrowsWithTheDrawingAndHasNoName) {
  Scene scene = head_and_hat();
  const ShiftedScene once = shifted(scene);
  const ShiftedScene twice = shifted(head_and_hat(2));
  for (Part& part : scene.parts) part.id += "-renamed";
  const ShiftedScene renamed = shifted(scene);
  ASSERT_EQ(once.ordering.h.size(), twice.ordering.h.size());
  for (size_t n = 0; n < once.ordering.h.size(); ++n)
    EXPECT_NEAR(2 * once.ordering.h[n], twice.ordering.h[n], 1e-6);
  EXPECT_EQ(once.ordering.h, renamed.ordering.h);
}

TEST(Cap, IsFoundAnewWhereOtherPartsAreTied) {
  const Scene upright = head_and_hat();
  Scene leaning = upright;
  leaning.parts[1].lean = {0, 0.1};
  const ShiftedScene relief = shifted(upright);
  OrderingSystem system;
  for (const Scene& scene : {upright, leaning, upright}) {
    const Result<Ordering> ordering =
        order_depth({relief.mesh, relief.discretisation, relief.inflation, scene}, {}, system);
    ASSERT_TRUE(ordering);
    EXPECT_EQ(ordering->h, shifted(scene).ordering.h);
  }
}

}  // namespace
}  // namespace relievo

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "relief/ordering/cap_rise.h"
#include "support/scenes.h"
#include "support/shifted_scene.h"

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using testing::shifted;
using testing::ShiftedScene;

constexpr OrderingOptions loose_caps{.close_caps = false};

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
  const std::vector<Cap> caps =
      find_caps({relief.mesh, relief.discretisation, scene}, tied_parts(scene), metric.A);
  return cap_rise(caps, relief.inflation, metric.scale);
}

/// Returns the largest distance of the hat's outline beside and above the head from the drawing
/// plane.
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

TEST(Cap, IsNoneWhereItGrowsLeansOrCrosses) {
  Scene leaning = head_and_hat();
  leaning.parts[1].lean = {0, 0.1};
  Scene above = head_and_hat();
  above.relations.clear();
  Scene grown = head_and_hat();
  grown.relations.clear();
  grown.joins = {{1, 0, {{120, 220}, {280, 220}}}};
  Scene sword = head_and_hat();
  sword.parts[1] = testing::part("sword", testing::rectangle(20, 240, 380, 260));
  for (const Scene& scene : {leaning, above, grown, sword}) {
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
        order_depth({relief.mesh, relief.discretisation, scene}, relief.inflation, {}, system);
    ASSERT_TRUE(ordering);
    EXPECT_EQ(ordering->h, shifted(scene).ordering.h);
  }
}

/// A head with an eye beside its middle, glued to it, and a pupil on that.
Scene head_and_eye(double by = 1) {
  Scene scene = head_and_hat(by);
  scene.parts[1] = testing::part("eye", testing::circle({by * 260, by * 220}, by * 30));
  scene.parts.push_back(testing::part("pupil", testing::circle({by * 265, by * 220}, by * 12)));
  scene.relations.push_back({2, 1, RelationKind::equal, std::nullopt});
  return scene;
}

/// Returns the range of the heights of the head's outline.
double bend(const ShiftedScene& relief) {
  double least = 1e9;
  double most = -1e9;
  for (size_t n = 0; n < relief.ordering.h.size(); ++n) {
    if (relief.mesh.node_part[n] != 0 || relief.mesh.node_role[n] != NodeRole::outline) continue;
    least = std::min(least, relief.ordering.h[n]);
    most = std::max(most, relief.ordering.h[n]);
  }
  return most - least;
}

/// Returns the shift of spots for heights in scene units.
VectorXd spots_of(const ShiftedScene& relief, const Scene& scene, const VectorXd& height) {
  const SurfaceInput surface{relief.mesh, relief.discretisation, scene};
  const std::vector<std::set<int>> tied = tied_parts(scene);
  return spot_rise(surface, tied, find_caps(surface, tied, metric_of(relief).A), height);
}

TEST(Spot, BendsWhatItLiesOnLess) {
  const ShiftedScene spot = shifted(head_and_eye());
  const ShiftedScene loose = shifted(head_and_eye(), loose_caps);
  const double top = *std::max_element(spot.ordering.h.begin(), spot.ordering.h.end());
  EXPECT_GT(bend(loose), 0.01 * top);
  EXPECT_LT(bend(spot), 0.25 * bend(loose));
  EXPECT_EQ(spot.ordering.max_violation, 0);
}

TEST(Spot, LiesOnAPlaneThatIsWhatItLiesOnWhereThatIsOne) {
  const ShiftedScene relief = shifted(head_and_eye());
  VectorXd height = VectorXd::Zero(static_cast<Index>(relief.ordering.h.size()));
  const auto slope = [&relief](Index n) {
    return 1 + 0.003 * relief.at(n).x - 0.002 * relief.at(n).y;
  };
  for (Index n = 0; n < height.size(); ++n)
    if (relief.mesh.node_part[n] == 0) height[n] = slope(n);
  const VectorXd rise = spots_of(relief, head_and_eye(), height);
  for (Index n = 0; n < height.size(); ++n)
    EXPECT_NEAR(rise[n], relief.mesh.node_part[n] == 0 ? 0 : slope(n), 1e-12);
}

TEST(Spot, IsLessOneTheMoreSticksOut) {
  std::vector<double> shares;
  for (const double x : {285.0, 296.0, 298.0, 310.0}) {
    Scene scene = head_and_eye();
    scene.parts.pop_back();
    scene.relations.pop_back();
    scene.parts[1] = testing::part("eye", testing::circle({x, 250}, 30));
    const ShiftedScene relief = shifted(scene);
    const VectorXd f = metric_of(relief).scale * inflated_heights(relief.inflation.u);
    const VectorXd rise = spots_of(relief, scene, f);
    shares.push_back(rise.maxCoeff() / f.maxCoeff());
  }
  EXPECT_GT(shares[0], 0.5);
  EXPECT_LT(shares[1], 0.9 * shares[0]);
  EXPECT_LT(shares[2], shares[1]);
  EXPECT_GT(shares[2], 0.001);
  EXPECT_EQ(shares[3], 0);
}

TEST(Spot, ComesForwardAsOneWithWhatSticksOut) {
  Scene scene = head_and_eye();
  scene.parts.pop_back();
  scene.relations.pop_back();
  scene.parts[1] = testing::part("eye", testing::circle({296, 250}, 30));
  const ShiftedScene relief = shifted(scene);
  const VectorXd f = metric_of(relief).scale * inflated_heights(relief.inflation.u);
  const VectorXd rise = spots_of(relief, scene, f);
  std::vector<Index> eye;
  for (Index n = 0; n < rise.size(); ++n)
    if (relief.mesh.node_part[n] == 1) eye.push_back(n);
  Eigen::MatrixX3d places(eye.size(), 3);
  for (Index i = 0; i < places.rows(); ++i)
    places.row(i) << 1, relief.at(eye[i]).x, relief.at(eye[i]).y;
  const VectorXd on_eye = rise(eye);
  const Eigen::Vector3d plane = places.colPivHouseholderQr().solve(on_eye);
  EXPECT_GT(on_eye.norm(), 0);
  EXPECT_LT((places * plane - on_eye).norm(), 1e-12 * on_eye.norm());
}

TEST(Spot, IsNoneWhereItGrowsLeansOrIsNotTied) {
  Scene leaning = head_and_eye();
  leaning.parts[1].lean = {0, 0.1};
  Scene above = head_and_eye();
  above.relations.clear();
  Scene grown = head_and_eye();
  grown.relations.clear();
  grown.joins = {{1, 0, {{260, 190}, {260, 250}}}};
  for (Scene scene : {leaning, above, grown}) {
    scene.parts.pop_back();
    std::erase_if(scene.relations, [](const Relation& relation) { return relation.upper == 2; });
    EXPECT_EQ(shifted(scene).ordering.h, shifted(scene, loose_caps).ordering.h);
  }
}

TEST(Spot, GrowsWithTheDrawingAndHasNoName) {
  Scene scene = head_and_eye();
  const ShiftedScene once = shifted(scene);
  const ShiftedScene twice = shifted(head_and_eye(2));
  for (Part& part : scene.parts) part.id += "-renamed";
  EXPECT_EQ(once.ordering.h, shifted(scene).ordering.h);
  ASSERT_EQ(once.ordering.h.size(), twice.ordering.h.size());
  for (size_t n = 0; n < once.ordering.h.size(); ++n)
    EXPECT_NEAR(2 * once.ordering.h[n], twice.ordering.h[n], 1e-6);
}

}  // namespace
}  // namespace relievo::relief

#include "understanding/joins/propose_leans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "kernel/image/outlines.h"
#include "support/label_maps.h"
#include "understanding/joins/propose_joins.h"

namespace relievo::understanding {
namespace {

using namespace testing;

constexpr int width = 300;
constexpr int height = 300;

/// The tilts of shapes painted back to front, which are known where hidden too; by part.
std::map<int, double> leans_of(const std::vector<Inside>& shapes, double sure = 1) {
  const PartRegions regions = find_regions(painted(width, height, shapes));
  std::vector<OrderArrow> order;
  Completion completion;
  std::vector<Outline> outlines;
  for (int part = 0; part < regions.count(); ++part) {
    for (int lower = 0; lower < part; ++lower)
      order.push_back({regions.labels[part], regions.labels[lower], sure});
    const PartRegions alone = find_regions(painted(width, height, {shapes[part]}));
    completion.push_back({alone.visible[0], CompletionKind::whole, {}});
    outlines.push_back(outline_of(alone.visible[0]));
  }
  const std::vector<ProposedJoin> joins = propose_joins(regions, outlines, order).joins;
  std::map<int, double> leans;
  for (const ProposedLean& lean : propose_leans(regions, order, completion, joins)) {
    EXPECT_EQ(lean.lean.y, 0);
    EXPECT_GT(lean.confidence, 0);
    EXPECT_LE(lean.confidence, 1);
    leans[lean.part] = lean.lean.x;
  }
  return leans;
}

const Inside body = oval(150, 150, 70, 100, 0);
const Inside right_arm = oval(205, 140, 15, 50, -0.2);
const Inside left_arm = oval(95, 140, 15, 50, 0.2);

/// A trunk turned by `angle`, cut at the height of its limbs: an ellipse with 0.8 times as much
/// depth as width.
struct Section {
  double angle = 0;

  Point2 at(double s) const {  // x to the right, y to the viewer
    const double x = std::cos(s);
    const double z = 0.8 * std::sin(s);
    return {x * std::cos(angle) - z * std::sin(angle), x * std::sin(angle) + z * std::cos(angle)};
  }

  double half_width() const {
    double most = 0;
    for (int i = 0; i < 100000; ++i) most = std::max(most, at(2e-5 * std::numbers::pi * i).x);
    return most;
  }

  /// Between front and back at x, by halving.
  double middle(double x) const {
    double sum = 0;
    for (const double side : {0.0, std::numbers::pi}) {
      // The curve runs from the rightmost point to the leftmost, through the front or the back.
      double right = side - std::atan2(0.8 * std::sin(angle), std::cos(angle)) +
                     (side > 0 ? std::numbers::pi : 0);
      double left = side > 0 ? right - std::numbers::pi : right + std::numbers::pi;
      for (int i = 0; i < 60; ++i) {
        const double between = (left + right) / 2;
        (at(between).x > x ? right : left) = between;
      }
      sum += at(left).y / 2;
    }
    return sum;
  }
};

TEST(LeanOfRoots, IsThatOfATurnedEllipse) {
  for (const double angle : {0.1, 0.3, 0.6, 0.9, 1.15}) {
    const Section section{angle};
    const double distance = std::cos(angle) / section.half_width();
    const double slope = section.middle(0.5) - section.middle(-0.5);
    EXPECT_NEAR(lean_of_roots(distance), slope, 1e-6) << angle;
  }
}

TEST(LeanOfRoots, FrontAndSideViewsTellOfNone) {
  for (const double distance : {0.0, 0.1, 0.25, 1.0, 1.4}) EXPECT_EQ(lean_of_roots(distance), 0);
  EXPECT_GT(lean_of_roots(0.3), 0);
  EXPECT_LE(lean_of_roots(0.3), lean_of_roots(0.45));
}

TEST(ProposeLeans, TheTrunkLeansTowardsTheNearLimb) {
  const std::map<int, double> right = leans_of({left_arm, body, right_arm});
  ASSERT_EQ(right.size(), 1U);
  EXPECT_GT(right.at(1), 0.12);
  EXPECT_LT(right.at(1), 0.23);
  const std::map<int, double> left = leans_of({right_arm, body, left_arm});
  ASSERT_EQ(left.size(), 1U);
  EXPECT_NEAR(left.at(1), -right.at(1), 1e-3);
}

TEST(ProposeLeans, AllOfTheTrunkLeans) {
  // A breast that is joined to the body, a patch on both, a head that is not joined to the body,
  // with a nose.
  const std::map<int, double> leans =
      leans_of({left_arm, body, oval(150, 95, 50, 50, 0), disc(150, 30, 20), disc(145, 130, 30),
                right_arm, disc(140, 25, 4)});
  ASSERT_EQ(leans.size(), 3U);
  EXPECT_EQ(leans.count(1) + leans.count(2) + leans.count(4), 3U);
  EXPECT_EQ(leans.at(1), leans.at(2));
  EXPECT_EQ(leans.at(1), leans.at(4));
}

TEST(ProposeLeans, LimbsOnOneSideOfTheOrderTellNothing) {
  EXPECT_TRUE(leans_of({body, left_arm, right_arm}).empty());
  EXPECT_TRUE(leans_of({left_arm, right_arm, body}).empty());
}

TEST(ProposeLeans, LimbsThatAreNoCounterpartsTellNothing) {
  EXPECT_TRUE(leans_of({oval(95, 140, 8, 14, 0), body, right_arm}).empty()) << "another size";
  EXPECT_TRUE(leans_of({oval(110, 220, 15, 50, 0.2), body, right_arm}).empty()) << "lower";
  EXPECT_TRUE(leans_of({oval(200, 60, 15, 50, 0.5), body, right_arm}).empty()) << "the same side";
  EXPECT_TRUE(leans_of({left_arm, body, oval(155, 140, 15, 50, 0)}).empty()) << "in the middle";
}

TEST(ProposeLeans, GuessesOfTheOrderThatMayBeWrongTellNothing) {
  EXPECT_TRUE(leans_of({left_arm, body, right_arm}, 0.1).empty());
}

/// A quadruped from the side with its legs at these places: far hind, far fore, near hind, near
/// fore.
std::map<int, double> quadruped(std::array<double, 4> legs) {
  const auto leg = [](double x) { return box(x - 10, 150, x + 10, 260); };
  return leans_of(
      {leg(legs[0]), leg(legs[1]), oval(150, 140, 110, 50, 0), leg(legs[2]), leg(legs[3])});
}

TEST(ProposeLeans, SideViewsOfQuadrupedsLeanNowhere) {
  EXPECT_TRUE(quadruped({95, 225, 75, 205}).empty());
  EXPECT_TRUE(quadruped({55, 245, 85, 215}).empty());
  EXPECT_TRUE(quadruped({105, 195, 75, 225}).empty());
}

}  // namespace
}  // namespace relievo::understanding

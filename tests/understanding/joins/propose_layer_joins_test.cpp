#include "understanding/joins/propose_layer_joins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel/geometry/polyline.h"
#include "support/disc_with_limbs.h"
#include "understanding/scene/connect_scene.h"

namespace relievo::understanding {
namespace {

using namespace testing;

bool is_joined_from_behind(const JoinProposals& joining, int upper, int lower) {
  return is_equal(joining, upper, lower, RelationKind::joined);
}

const PartColors::value_type fur = {{0.8, 0.6, 0.4}};
const PartColors::value_type steel = {{0.1, 0.2, 0.9}};

TEST(ConnectParts, TheJoinOfALimbIsOneRadianOfItsCapToEachSide) {
  const JoinProposals joining = propose_layer_joins(disc_with({limb()}));
  ASSERT_EQ(joining.joins.size(), 1U);
  const Join& join = joining.joins[0].join;
  EXPECT_EQ(join.upper, 1);
  EXPECT_EQ(join.lower, 0);
  EXPECT_GT(joining.joins[0].confidence, 0.5);
  EXPECT_NEAR(line_length(join.line), 2 * 22, 6);
  for (const Point2 p : join.line) EXPECT_NEAR(distance(p, {200, 200}), 22, 0.5);
  for (const Point2 end : {join.line.front(), join.line.back()})
    EXPECT_NEAR(std::atan2(std::abs(end.x - 200), 200 - end.y), 1, 0.15);
}

TEST(ConnectParts, EndsOfAJoinGoToNearAnchorsOnItsOutline) {
  const auto on_cap = [](double angle, double radius = 22) {
    return Point2{200 + radius * std::sin(angle), 200 - radius * std::cos(angle)};
  };
  const auto ends = [](const std::vector<Point2>& anchors) {
    const std::vector<Point2> line =
        propose_layer_joins(disc_with({limb()}), {}, anchors).joins.at(0).join.line;
    std::vector<double> angles;
    for (const Point2 end : {line.front(), line.back()})
      angles.push_back(std::atan2(end.x - 200, 200 - end.y));
    std::sort(angles.begin(), angles.end());
    return angles;
  };
  const std::vector<double> free = ends({});
  const std::vector<double> drawn = ends({on_cap(-0.8), on_cap(1.3)});
  EXPECT_NEAR(drawn[0], -0.8, 0.02);
  EXPECT_NEAR(drawn[1], 1.3, 0.02);
  EXPECT_EQ(ends({on_cap(0)}), free) << "too far from both";
  EXPECT_EQ(ends({on_cap(-0.8, 18), on_cap(1.3, 26)}), free) << "not on the outline";
}

TEST(ConnectParts, ABentArmIsJoinedAtItsEnd) {
  Ring arm = {{40, 175}, {180, 175}};
  for (int i = 0; i <= 20; ++i)
    arm.push_back(Point2{200, 120} +
                  20.0 * Point2{-std::cos(M_PI * i / 20), -std::sin(M_PI * i / 20)});
  arm.insert(arm.end(), {{220, 215}, {40, 215}});
  const PartColors::value_type skin = {{0.8, 0.6, 0.4}};
  const JoinProposals joining = propose_layer_joins(disc_with({arm}), {skin, skin});
  ASSERT_EQ(joining.joins.size(), 1U);
  const std::vector<Point2>& line = joining.joins[0].join.line;
  for (const Point2 end : {line.front(), line.back()})
    EXPECT_NEAR(std::atan2(std::abs(end.x - 200), 120 - end.y), 1, 0.3);
  EXPECT_LT((line.front().x - 200) * (line.back().x - 200), 0) << "to both sides of its end";
}

TEST(ConnectParts, HairThatCoversAHeadIsTiedAndNotJoined) {
  const PartColors::value_type skin = {{0.9, 0.7, 0.5}};
  const PartColors::value_type brown = {{0.7, 0.5, 0.3}};
  const Ring hair = rectangle(100, 50, 300, 180);
  const Ring fringe = rectangle(100, 50, 300, 120);
  const JoinProposals joining = propose_layer_joins(disc_with({hair}), {skin, skin});
  EXPECT_TRUE(joining.joins.empty());
  EXPECT_TRUE(is_equal(joining, 1, 0));
  EXPECT_EQ(propose_layer_joins(disc_with({fringe}), {skin, brown}).joins.size(), 1U);
}

TEST(ConnectParts, JoinsMoveWithTheDrawing) {
  for (const double angle : {0.3, 1.2, 2.5, 4.0}) {
    for (const double scale : {0.5, 3.0}) {
      const auto moved = [&](Point2 p) {
        const Point2 q = p - Point2{200, 200};
        return scale * Point2{200 + std::cos(angle) * q.x - std::sin(angle) * q.y,
                              200 + std::sin(angle) * q.x + std::cos(angle) * q.y};
      };
      const Scene scene = disc_with({limb()});
      Scene turned = scene;
      turned.width *= scale;
      turned.height *= scale;
      for (Part& part : turned.parts)
        for (Point2& p : part.outline[0]) p = moved(p);
      const JoinProposals a = propose_layer_joins(scene);
      const JoinProposals b = propose_layer_joins(turned);
      ASSERT_EQ(a.joins.size(), 1U);
      ASSERT_EQ(b.joins.size(), 1U);
      const Join& join = b.joins[0].join;
      const auto near = [&](Point2 p) {
        return std::min(distance(p, join.line.front()), distance(p, join.line.back())) / scale;
      };
      EXPECT_LT(near(moved(a.joins[0].join.line.front())), 5) << angle << " " << scale;
      EXPECT_LT(near(moved(a.joins[0].join.line.back())), 5) << angle << " " << scale;
    }
  }
}

TEST(ConnectParts, TheWayRoundOfAnOutlineDoesNotMatter) {
  Scene reversed = disc_with({limb()});
  for (Part& part : reversed.parts) std::reverse(part.outline[0].begin(), part.outline[0].end());
  const JoinProposals a = propose_layer_joins(disc_with({limb()}));
  const JoinProposals b = propose_layer_joins(reversed);
  ASSERT_EQ(a.joins.size(), 1U);
  ASSERT_EQ(b.joins.size(), 1U);
  EXPECT_NEAR(line_length(a.joins[0].join.line), line_length(b.joins[0].join.line), 5);
}

TEST(ConnectParts, RandomLimbsAreJoinedWhereTheyGrow) {
  int limbs = 0;
  int found = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = random_limbs(seed);
    if (scene.joins.size() != 1) continue;
    ++limbs;
    const JoinProposals joining = propose_layer_joins(scene);
    for (const ProposedJoin& proposed : joining.joins) {
      const Join& join = proposed.join;
      if (join.upper != scene.joins[0].upper || join.lower != scene.joins[0].lower) continue;
      const Point2 tip = scene.joins[0].line[10];
      found += std::any_of(join.line.begin(), join.line.end(),
                           [&](Point2 p) { return distance(p, tip) < 4; })
                   ? 1
                   : 0;
    }
  }
  ASSERT_GT(limbs, 10);
  EXPECT_GE(found, limbs * 9 / 10) << found << " of " << limbs;
}

TEST(ConnectParts, WhatLiesInsideIsTied) {
  const JoinProposals joining = propose_layer_joins(disc_with({circle({210, 150}, 20)}));
  EXPECT_TRUE(joining.joins.empty());
  EXPECT_TRUE(is_equal(joining, 1, 0));
}

TEST(ConnectParts, LimbsBehindAreJoinedFromThere) {
  const JoinProposals joining = propose_layer_joins(disc_with({}, {limb()}));
  EXPECT_TRUE(joining.joins.empty());
  EXPECT_TRUE(is_joined_from_behind(joining, 1, 0));
  EXPECT_GT(joining.relations.at(0).confidence, 0.5);
}

TEST(ConnectParts, WhatReachesOutOnTwoSidesIsNoLimb) {
  const JoinProposals joining = propose_layer_joins(disc_with({rectangle(60, 140, 340, 180)}));
  EXPECT_TRUE(joining.joins.empty());
  EXPECT_TRUE(is_equal(joining, 1, 0));
}

TEST(ConnectParts, ALimbJoinsWhatLiesDirectlyUnderItsRoot) {
  const JoinProposals joining = propose_layer_joins(disc_with({circle({200, 190}, 60), limb()}));
  ASSERT_EQ(joining.joins.size(), 1U);
  EXPECT_EQ(joining.joins[0].join.upper, 2);
  EXPECT_EQ(joining.joins[0].join.lower, 1);
}

TEST(ConnectParts, AJoinedLimbIsNotTiedToTheLimbThatItCrosses) {
  const Scene scene = disc_with({limb()}, {capsule({215, 200}, M_PI / 2, 150, 25)});
  const JoinProposals joining = propose_layer_joins(scene);
  ASSERT_EQ(joining.joins.size(), 1U);
  EXPECT_EQ(joining.joins[0].join.lower, 1);
  EXPECT_FALSE(is_equal(joining, 2, 0));
  EXPECT_TRUE(is_joined_from_behind(joining, 1, 0)) << "the far limb still hangs on the body";
}

TEST(ConnectParts, WhatCoversTheRootOfALimbDoesNotGrowOutOfIt) {
  const Ring tail = capsule({250, 200}, 0.785, 160, 14);
  const auto lowers = [&](const Ring& foot) {
    std::vector<int> lower;
    for (const ProposedJoin& proposed : propose_layer_joins(disc_with({foot}, {tail})).joins)
      lower.push_back(proposed.join.lower);
    return lower;
  };
  EXPECT_EQ(lowers(capsule({276, 240}, M_PI / 2, 60, 18)), std::vector<int>{}) << "a foot beside";
  EXPECT_EQ(lowers(circle({362, 312}, 22)), std::vector<int>{0}) << "a tuft at its end";
}

Ring ellipse(Point2 centre, double a, double b) {
  Ring ring;
  for (int i = 0; i < 60; ++i) {
    const double t = 2 * M_PI * i / 60;
    ring.push_back({centre.x + a * std::cos(t), centre.y + b * std::sin(t)});
  }
  return ring;
}

TEST(ConnectParts, WhatIsHeldInItsMiddleHasNoRootToStandBeside) {
  const auto crown_grows = [](double shift) {
    const JoinProposals joining = propose_layer_joins(
        disc_with({ellipse({200 + shift, 80}, 130, 16), circle({200, 50}, 45)}));
    return std::any_of(joining.joins.begin(), joining.joins.end(), [](const ProposedJoin& guess) {
      return guess.join.upper == 2 && guess.join.lower == 1;
    });
  };
  EXPECT_TRUE(crown_grows(0)) << "a hat";
  EXPECT_FALSE(crown_grows(80)) << "a ball before the root of a beak";
}

TEST(ConnectParts, WhatAHandHoldsIsNotTiedToWhatItCrosses) {
  const Ring bar = rectangle(60, 140, 340, 160);
  const Ring hand = rectangle(10, 100, 100, 220);
  const JoinProposals joining = propose_layer_joins(disc_with({bar, hand}), {fur, steel, fur});
  EXPECT_TRUE(is_equal(joining, 2, 1)) << "and does not grow out of the hand";
  EXPECT_FALSE(is_equal(joining, 1, 0));
  EXPECT_TRUE(
      is_joined_from_behind(propose_layer_joins(disc_with({bar, hand}), {fur, fur, fur}), 2, 1));
}

TEST(ConnectParts, WhatMostlyLiesOnAPartIsTiedToItWhateverHidesTheRest) {
  const Ring eye = circle({210, 150}, 20);
  const Ring fringe = rectangle(210, 120, 330, 200);
  const JoinProposals joining = propose_layer_joins(disc_with({eye, fringe}));
  EXPECT_TRUE(is_equal(joining, 2, 1));
  EXPECT_TRUE(is_equal(joining, 1, 0));
}

TEST(ConnectParts, WhatIsOfAForeignColourIsHeldAndDoesNotGrow) {
  const Scene scene = disc_with({limb()});
  EXPECT_EQ(propose_layer_joins(scene, {fur, fur}).joins.size(), 1U);
  EXPECT_TRUE(propose_layer_joins(scene, {fur, steel}).joins.empty());
  EXPECT_TRUE(is_equal(propose_layer_joins(scene, {fur, steel}), 1, 0));
}

TEST(ConnectParts, HairMayHaveAnyColour) {
  const Scene scene = disc_with({circle({200, 60}, 85)});
  ASSERT_EQ(propose_layer_joins(scene, {fur, fur}).joins.size(), 1U);
  EXPECT_TRUE(propose_layer_joins(scene, {fur, steel}).joins.empty());
  const Scene covered = disc_with({circle({200, 92}, 70)});
  EXPECT_EQ(propose_layer_joins(covered, {fur, steel}).joins.size(), 1U);
}

TEST(ConnectParts, OneColourOfTheBodyIsEnough) {
  EXPECT_EQ(propose_layer_joins(disc_with({limb()}), {{steel[0], fur[0]}, fur}).joins.size(), 1U);
}

TEST(ConnectParts, OfTwoPartsALimbGrowsOutOfTheOneOfItsColour) {
  const Scene scene =
      disc_with({capsule({290, 200}, M_PI / 2, 150, 40), capsule({280, 150}, 0.5, 110, 20)});
  const JoinProposals on_body = propose_layer_joins(scene, {fur, {{0.5, 0.2, 0.1}}, fur});
  const JoinProposals on_limb = propose_layer_joins(scene, {{{0.5, 0.2, 0.1}}, fur, fur});
  const auto lower_of_last = [](const JoinProposals& joining) {
    int lower = -1;
    int count = 0;
    for (const ProposedJoin& proposed : joining.joins)
      if (proposed.join.upper == 2) {
        lower = proposed.join.lower;
        ++count;
      }
    EXPECT_EQ(count, 1);
    return lower;
  };
  EXPECT_EQ(lower_of_last(on_body), 0);
  EXPECT_EQ(lower_of_last(on_limb), 1);
}

TEST(ConnectParts, AnArmThatLiesMostlyOnTheBodyIsJoinedWhereItHasItsColour) {
  const Scene scene = disc_with({capsule({160, 130}, 0.7, 145, 20)});
  EXPECT_TRUE(propose_layer_joins(scene).joins.empty());
  EXPECT_EQ(propose_layer_joins(scene, {fur, fur}).joins.size(), 1U);
}

TEST(ConnectParts, NecksAreNarrowerThanHeads) {
  const JoinProposals joining = propose_layer_joins(disc_with({circle({200, 60}, 60)}));
  ASSERT_EQ(joining.joins.size(), 1U);
  EXPECT_NEAR(line_length(joining.joins[0].join.line), 0.45 * std::sqrt(M_PI) * 60, 4);
}

TEST(ConnectParts, WideDarkRedPatchesAreOpenMouths) {
  const PartColors::value_type red = {{0.5, 0.1, 0.12}};
  const PartColors::value_type black = {{0.1, 0.1, 0.1}};
  const Scene mouth = disc_with({ellipse({200, 190}, 30, 12)});
  EXPECT_EQ(propose_layer_joins(mouth, {fur, red}).hollows, std::vector<int>{1});
  EXPECT_TRUE(propose_layer_joins(mouth, {fur, black}).hollows.empty()) << "an eye";
  EXPECT_TRUE(propose_layer_joins(mouth).hollows.empty());
  EXPECT_TRUE(propose_layer_joins(disc_with({circle({200, 180}, 20)}), {fur, red}).hollows.empty())
      << "a nose";
}

TEST(ConnectParts, PinkInsideAnEarIsACup) {
  const PartColors::value_type pink = {{0.95, 0.72, 0.7}};
  const Ring ear = capsule({200, 100}, -M_PI / 2, 90, 26);
  const Ring cup = capsule({200, 70}, -M_PI / 2, 55, 14);
  const Scene in_front = disc_with({ear, cup});
  EXPECT_EQ(propose_layer_joins(in_front, {fur, fur, pink}).hollows, std::vector<int>{2});
  EXPECT_TRUE(propose_layer_joins(in_front, {fur, fur, steel}).hollows.empty());
  EXPECT_TRUE(propose_layer_joins(in_front, {fur, fur, {{0.4, 0.28, 0.22}}}).hollows.empty())
      << "a brown nose on a muzzle";
  const Scene behind = disc_with({}, {ear, cup});
  EXPECT_EQ(propose_layer_joins(behind, {fur, pink, fur}).hollows, std::vector<int>{1});
  EXPECT_TRUE(
      propose_layer_joins(disc_with({ellipse({200, 190}, 30, 30)}), {fur, pink}).hollows.empty())
      << "a cheek";
}

TEST(ConnectScene, HollowsAreDishesOnlyWhereAmountsAreGuessed) {
  const Scene mouth = disc_with({ellipse({200, 190}, 30, 12)});
  const PartColors colors = {fur, {{0.5, 0.1, 0.12}}};
  EXPECT_LT(connect_scene(mouth, true, colors).scene.parts[1].d, 0);
  EXPECT_GT(connect_scene(mouth, false, colors).scene.parts[1].d, 0);
}

TEST(ConnectScene, FeaturesBulgeLessThanBallsAndTheLargerTheLess) {
  const auto amount = [](const std::vector<Ring>& front, bool guessed = true) {
    return connect_scene(disc_with(front), guessed).scene.parts.back().c;
  };
  const Ring eye = circle({200, 160}, 9);  // a hundredth of the disc
  EXPECT_NEAR(amount({eye}), 4 * 0.4 * (1 - 1.5 * 0.1), 0.03);
  EXPECT_LT(amount({circle({200, 160}, 18)}), amount({eye}));
  EXPECT_NEAR(amount({circle({200, 160}, 18), eye}), 4 * 0.4 * (1 - 1.5 * 0.5), 0.03)
      << "a pupil lies on its eye";
  EXPECT_NEAR(amount({circle({200, 160}, 40)}), 4, 0.01) << "a heart that is held";
  EXPECT_NEAR(amount({circle({200, 250}, 9)}), 4, 0.01) << "reaches beyond";
  EXPECT_GT(amount({ellipse({200, 160}, 24, 6)}), 2) << "an arm before the body";
  EXPECT_EQ(amount({eye}, false), disc_with({eye}).parts.back().c);
}

TEST(ConnectParts, WhatALargerPartMostlyHidesHangsOnThat) {
  for (const Ring& hidden : {circle({200, 80}, 30), circle({200, 180}, 80)}) {
    const JoinProposals joining = propose_layer_joins(disc_with({}, {hidden}));
    EXPECT_TRUE(joining.joins.empty());
    EXPECT_TRUE(is_equal(joining, 1, 0));
  }
}

}  // namespace
}  // namespace relievo::understanding

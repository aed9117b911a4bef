#include "understanding/scene/connect_scene.h"

#include <gtest/gtest.h>

#include "support/disc_with_limbs.h"
#include "understanding/joins/propose_layer_joins.h"

namespace relievo::understanding {
namespace {

using namespace testing;

TEST(ConnectScene, TheAuthorsWordStandsForThePartsThatItPlaces) {
  Scene scene = disc_with({limb(), circle({210, 120}, 20)});
  scene.relations.push_back({1, 0, RelationKind::above, std::nullopt});
  const ConnectedScene connected = connect_scene(scene, false);
  EXPECT_TRUE(connected.scene.joins.empty());
  ASSERT_EQ(connected.scene.relations.size(), 2U);
  EXPECT_EQ(connected.scene.relations[0].kind, RelationKind::above);
  EXPECT_FALSE(is_equal(connected.proposals, 1, 0));
  EXPECT_TRUE(is_equal(connected.proposals, 2, 0));
}

TEST(ConnectScene, NothingElseGrowsWhereTheAuthorSaysWhatDoes) {
  Scene scene = disc_with({limb(), capsule({240, 160}, 0, 150, 22)});
  const std::vector<ProposedJoin> guesses = propose_layer_joins(scene).joins;
  ASSERT_EQ(guesses.size(), 2U);
  scene.joins.push_back(guesses[0].join);
  const ConnectedScene connected = connect_scene(scene, false);
  ASSERT_EQ(connected.scene.joins.size(), 1U);
  EXPECT_EQ(connected.scene.joins[0].upper, guesses[0].join.upper);
  EXPECT_TRUE(connected.proposals.joins.empty());
  EXPECT_TRUE(is_equal(connected.proposals, 2, 0));
}

TEST(ConnectScene, WhatIsSaidOfALimbBehindSaysNothingOfItsBody) {
  Scene scene = disc_with({}, {rectangle(60, 20, 340, 300), limb()});
  scene.relations.push_back({2, 1, RelationKind::joined, std::nullopt});
  EXPECT_TRUE(is_equal(connect_scene(scene, false).proposals, 2, 0));
}

TEST(ConnectScene, WhatIsSaidOfAnEarsCupSaysNothingOfTheEar) {
  const Ring ear = capsule({200, 100}, -M_PI / 2, 90, 26);
  Scene scene = disc_with({}, {ear, capsule({200, 40}, -M_PI / 2, 25, 14)});
  scene.relations.push_back({1, 0, RelationKind::equal, std::nullopt});
  EXPECT_TRUE(is_equal(connect_scene(scene, false).proposals, 2, 0));
}

TEST(ConnectScene, ProposalsAreWhatTheSceneHas) {
  const ConnectedScene connected = connect_scene(disc_with({limb(), circle({210, 120}, 20)}), true);
  ASSERT_EQ(connected.scene.joins.size(), connected.proposals.joins.size());
  ASSERT_EQ(connected.scene.relations.size(), connected.proposals.relations.size());
  EXPECT_TRUE(validate(connected.scene));
  EXPECT_NEAR(connected.scene.parts[0].c, 4, 0.05);  // a disc becomes a hemisphere
  EXPECT_LT(connected.scene.parts[1].c, 2.5);        // a long limb a half cylinder
}

}  // namespace
}  // namespace relievo::understanding

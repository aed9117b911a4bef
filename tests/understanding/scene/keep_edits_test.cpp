#include "understanding/scene/keep_edits.h"

#include <gtest/gtest.h>

namespace relievo::understanding {
namespace {

Part part(const std::string& id, double c = 4) {
  return {id, {{{10, 10}, {50, 10}, {50, 60}, {10, 60}}}, c, 1};
}

Scene scene_of(const std::vector<std::string>& ids) {
  Scene scene;
  scene.width = 100;
  scene.height = 80;
  for (const std::string& id : ids) scene.parts.push_back(part(id));
  return scene;
}

std::vector<std::string> names(const Scene& scene) {
  std::vector<std::string> ids;
  for (const Part& p : scene.parts) ids.push_back(p.id);
  return ids;
}

using Names = std::vector<std::string>;

/// Body, leg and ear were proposed; `scribbled` parts have strokes.
SegmentationRecord body_leg_ear(const std::vector<std::string>& scribbled = {}) {
  SegmentationRecord record;
  record.parts = {{1, "body", {}}, {2, "leg", {}}, {3, "ear", {}}};
  record.scribbles.parts = scribbled;
  return record;
}

TEST(KeepEdits, NothingChangesWhereNothingWasEdited) {
  Scene proposed = scene_of({"body", "leg", "ear"});
  proposed.joins = {{1, 0, {{10, 10}, {20, 10}}}};
  const Scene kept = keep_edits(proposed, {1, 2, 3}, proposed, body_leg_ear());
  EXPECT_EQ(names(kept), names(proposed));
  EXPECT_EQ(kept.joins.size(), 1U);
}

TEST(KeepEdits, RemovedPartsStayAwayWithWhatConnectsThem) {
  Scene proposed = scene_of({"body", "leg", "ear"});
  proposed.joins = {{1, 0, {{10, 10}, {20, 10}}}, {2, 0, {{30, 10}, {40, 10}}}};
  proposed.relations = {{2, 1, RelationKind::equal, std::nullopt}};
  proposed.robin = {{1, 0, {10, 10}, {10, 20}, std::nullopt, std::nullopt}};
  proposed.cues = {{1, CueKind::slope, {{10, 10}, {20, 10}}, 9},
                   {2, CueKind::crease, {{10, 10}, {20, 10}}, 40}};
  const Scene kept = keep_edits(proposed, {1, 2, 3}, scene_of({"body", "ear"}), body_leg_ear());
  EXPECT_EQ(names(kept), (Names{"body", "ear"}));
  ASSERT_EQ(kept.cues.size(), 1U);
  EXPECT_EQ(kept.cues[0].part, 1);
  EXPECT_EQ(kept.cues[0].value, 40);
  ASSERT_EQ(kept.joins.size(), 1U);
  EXPECT_EQ(kept.joins[0].upper, 1);
  EXPECT_EQ(kept.joins[0].line.front().x, 30);
  EXPECT_TRUE(kept.relations.empty());
  EXPECT_TRUE(kept.robin.empty());
}

TEST(KeepEdits, RemovedPartsWithNewStrokesComeBack) {
  const Scene proposed = scene_of({"body", "leg", "ear"});
  const Scene kept =
      keep_edits(proposed, {1, 2, 3}, scene_of({"body", "ear"}), body_leg_ear({"leg"}));
  EXPECT_EQ(names(kept), (Names{"body", "leg", "ear"}));
}

TEST(KeepEdits, DrawnPartsStayBetweenThoseBetweenWhichTheyLay) {
  Scene edited = scene_of({"tail", "body", "pocket", "leg", "ear"});
  edited.joins = {{2, 1, {{1, 1}, {2, 2}}}, {3, 1, {{3, 3}, {4, 4}}}};
  edited.relations = {{2, 0, RelationKind::free, std::nullopt}};
  // The ear lies below the leg now, and a new part was found.
  const Scene proposed = scene_of({"body", "ear", "leg", "part-4"});
  const Scene kept = keep_edits(proposed, {1, 3, 2, 4}, edited, body_leg_ear());
  EXPECT_EQ(names(kept), (Names{"tail", "body", "pocket", "ear", "leg", "part-4"}));
  ASSERT_EQ(kept.joins.size(), 1U) << "that of two proposed parts is proposed anew";
  EXPECT_EQ(kept.joins[0].upper, 2);
  EXPECT_EQ(kept.joins[0].lower, 1);
  ASSERT_EQ(kept.relations.size(), 1U);
  EXPECT_EQ(kept.relations[0].upper, 2);
  EXPECT_EQ(kept.relations[0].lower, 0);
}

TEST(KeepEdits, WhatConnectsADrawnPartToARemovedOneGoes) {
  Scene edited = scene_of({"body", "pocket"});
  edited.joins = {{1, 0, {{1, 1}, {2, 2}}}};
  const Scene kept = keep_edits(scene_of({"leg", "ear"}), {2, 3}, edited, body_leg_ear());
  EXPECT_EQ(names(kept), (Names{"pocket"}))
      << "the body is no more found, leg and ear were removed";
  EXPECT_TRUE(kept.joins.empty());
}

TEST(KeepEdits, ProposedPartsTakeNoNameOfADrawnOne) {
  Scene proposed = scene_of({"body", "part-4", "part-4-2"});
  avoid_drawn_names(scene_of({"body", "part-4"}), body_leg_ear(), proposed);
  EXPECT_EQ(names(proposed), (Names{"body", "part-4-3", "part-4-2"}));
}

}  // namespace
}  // namespace relievo::understanding

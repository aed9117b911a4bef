#include "understanding/scene/understand_drawing.h"

#include <gtest/gtest.h>

#include <set>

namespace relievo::understanding {
namespace {

constexpr int page_width = 120;
constexpr int page_height = 100;

/// A body with the label 1, an ear with the label 2 above it.
Image16 ear_on_body() {
  Image16 labels(page_width, page_height, 1);
  for (int y = 45; y < 90; ++y)
    for (int x = 15; x < 105; ++x) labels.pixels[y * page_width + x] = 1;
  for (int y = 10; y < 45; ++y)
    for (int x = 45; x < 65; ++x) labels.pixels[y * page_width + x] = 2;
  return labels;
}

Image8 paper() {
  Image8 rgba(page_width, page_height, 4);
  rgba.pixels.assign(rgba.pixels.size(), 255);
  return rgba;
}

Part square(const std::string& id, double x) {
  return {id, {{{x, 60}, {x + 20, 60}, {x + 20, 80}, {x, 80}}}, 4, 1};
}

std::vector<std::string> ids_in(const Scene& scene) {
  std::vector<std::string> ids;
  for (const Part& part : scene.parts) ids.push_back(part.id);
  return ids;
}

/// The body is known and has a name; the ear is new.
SegmentationRecord body_is_known() {
  SegmentationRecord known;
  known.labels = ear_on_body();
  known.parts = {{1, "body", CompletionKind::whole}};
  known.corrections.parts[1].id = "body";
  return known;
}

Scene scene_with(std::vector<Part> parts) {
  Scene scene;
  scene.width = page_width;
  scene.height = page_height;
  scene.parts = std::move(parts);
  return scene;
}

TEST(UnderstandDrawing, IsTheProposalWhereNothingWasEdited) {
  SegmentationRecord known;
  known.labels = ear_on_body();
  const auto understood = understand_drawing(paper(), {}, known);
  ASSERT_TRUE(understood) << to_string(understood.error());
  EXPECT_EQ(ids_in(understood->scene), ids_in(understood->proposal.scene));
  ASSERT_EQ(understood->record.parts.size(), 2U);
  for (size_t k = 0; k < 2; ++k) {
    const PartRecord& part = understood->record.parts[k];
    EXPECT_EQ(part.id, understood->scene.parts[k].id);
    EXPECT_EQ(part.id, "part-" + std::to_string(part.label));
  }
  EXPECT_EQ(understood->record.labels.pixels, known.labels.pixels);
}

TEST(UnderstandDrawing, GivesNoProposedPartTheNameOfADrawnOne) {
  const Scene edited = scene_with({square("body", 20), square("part-2", 60)});
  const auto understood = understand_drawing(paper(), {}, body_is_known(), edited);
  ASSERT_TRUE(understood) << to_string(understood.error());
  const std::vector<std::string> ids = ids_in(understood->scene);
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()),
            (std::set<std::string>{"body", "part-2", "part-2-2"}));
  ASSERT_EQ(ids.size(), 3U);
  EXPECT_TRUE(validate(understood->scene));
  std::set<std::string> recorded;
  for (const PartRecord& part : understood->record.parts) recorded.insert(part.id);
  EXPECT_EQ(recorded, (std::set<std::string>{"body", "part-2-2"}));
}

TEST(UnderstandDrawing, AgainAndAgainChangesNothing) {
  const Scene edited = scene_with({square("body", 20), square("part-2", 60)});
  const auto first = understand_drawing(paper(), {}, body_is_known(), edited);
  ASSERT_TRUE(first);
  const auto again = understand_drawing(paper(), {}, first->record, first->scene);
  ASSERT_TRUE(again);
  EXPECT_EQ(ids_in(again->scene), ids_in(first->scene));
  EXPECT_EQ(again->scene.joins.size(), first->scene.joins.size());
}

TEST(UnderstandDrawing, BringsRemovedPartsBackWhereTheyHaveStrokes) {
  SegmentationRecord known = body_is_known();
  const Scene edited = scene_with({square("patch", 60)});
  auto understood = understand_drawing(paper(), {}, known, edited);
  ASSERT_TRUE(understood);
  for (const std::string& id : ids_in(understood->scene)) EXPECT_NE(id, "body");
  EXPECT_EQ(understood->scene.parts.size(), 2U);
  known.scribbles.parts = {"body"};
  understood = understand_drawing(paper(), {}, known, edited);
  ASSERT_TRUE(understood);
  EXPECT_EQ(ids_in(understood->scene).size(), 3U);
}

TEST(UnderstandDrawing, HasNoPartsWhereAllWereRemoved) {
  SegmentationRecord known = body_is_known();
  known.parts.push_back({2, "ear", CompletionKind::whole});
  const auto understood = understand_drawing(paper(), {}, known);
  ASSERT_TRUE(understood);
  EXPECT_TRUE(understood->scene.parts.empty());
  EXPECT_EQ(understood->record.parts.size(), 2U);
}

TEST(UnderstandDrawing, KeepsLabelsNamesAndCorrectionsOfPartsThatAreLeft) {
  SegmentationRecord known = body_is_known();
  known.parts.push_back({2, "ear", CompletionKind::whole});
  known.corrections.parts[2].c = 2;
  known.corrections.parts[7].c = 3;
  Segmentation found;
  found.labels = ear_on_body();
  for (uint16_t& label : found.labels.pixels)
    if (label != 0) label = static_cast<uint16_t>(3 - label);
  found.parts.resize(2);
  found.parts[0].id = "ear";
  found.parts[0].proposed = false;
  found.parts[0].label = 1;
  found.parts[1].label = 2;
  found.notes = {"a note"};
  const auto understood = understand_drawing(paper(), found, known);
  ASSERT_TRUE(understood) << to_string(understood.error());
  EXPECT_EQ(understood->segmentation.parts[0].label, 2);
  EXPECT_EQ(understood->segmentation.parts[1].label, 1);
  EXPECT_EQ(understood->record.labels.pixels, known.labels.pixels);
  EXPECT_EQ(understood->warnings, found.notes);
  const auto& said = understood->record.corrections.parts;
  EXPECT_EQ(said.size(), 2U);
  EXPECT_EQ(said.at(2).c, 2);
  EXPECT_EQ(said.at(2).id, "ear");
}

TEST(UnderstandDrawing, WhatNothingIsDrawnBetweenGrowsTogether) {
  SegmentationRecord known;
  known.labels = ear_on_body();
  const auto joins = [&](const Image8& rgba) {
    const Result<Understanding> understood = understand_drawing(rgba, {}, known);
    EXPECT_TRUE(understood.ok());
    return understood->record.joins;
  };
  const auto open = joins(paper());
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].upper, 2) << "the smaller one is the limb";
  EXPECT_EQ(open[0].confidence, 1);
  Image8 lined = paper();
  for (int x = 0; x < page_width; ++x)
    for (int c = 0; c < 3; ++c) lined.at(x, 45, c) = 0;
  for (const JoinRecord& join : joins(lined)) EXPECT_LT(join.confidence, 1);
}

}  // namespace
}  // namespace relievo::understanding

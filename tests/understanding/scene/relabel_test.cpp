#include <gtest/gtest.h>

#include <set>
#include <string>

#include "understanding/scene/keep_edits.h"

namespace relievo::understanding {
namespace {

/// A row of 20 pixels for each letter of a picture; '.' is background.
Image16 row_of(const std::string& letters) {
  Image16 labels(20 * static_cast<int>(letters.size()), 1, 1);
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    labels.pixels[i] =
        letters[i / 20] == '.' ? uint16_t{0} : static_cast<uint16_t>(letters[i / 20] - 'a' + 1);
  return labels;
}

/// `proposed` holds for each label in turn; ids are "a", "b", ...
Segmentation segmentation_of(const std::string& letters, const std::vector<bool>& proposed) {
  Segmentation segmentation;
  segmentation.labels = row_of(letters);
  for (size_t k = 0; k < proposed.size(); ++k) {
    SegmentedPart& part = segmentation.parts.emplace_back();
    part.id = std::string(1, static_cast<char>('a' + k));
    part.proposed = proposed[k];
    part.label = static_cast<PartLabel>(k + 1);
  }
  return segmentation;
}

SegmentationRecord known(const std::string& letters, const std::vector<PartRecord>& parts = {}) {
  SegmentationRecord record;
  record.labels = row_of(letters);
  record.parts = parts;
  return record;
}

std::vector<PartLabel> labels_of(const Segmentation& segmentation) {
  std::vector<PartLabel> labels;
  for (const SegmentedPart& part : segmentation.parts) labels.push_back(part.label);
  return labels;
}

/// The labels of the parts after relabel.
std::vector<PartLabel> relabelled(Segmentation segmentation, SegmentationRecord record) {
  relabel(segmentation, record);
  EXPECT_EQ(record.labels.pixels, segmentation.labels.pixels);
  return labels_of(segmentation);
}

using Labels = std::vector<PartLabel>;

TEST(Relabel, NumbersFromOneWhereNothingIsKnown) {
  EXPECT_EQ(relabelled(segmentation_of("aab.bc", {true, true, true}), {}), (Labels{1, 2, 3}));
}

TEST(Relabel, GivesProposedPartsTheLabelWithWhichTheyShareMost) {
  Segmentation segmentation = segmentation_of("bbbaaaaaa.cc", {true, true, true});
  segmentation.bridges = {{{}, 0, 2}};
  SegmentationRecord record = known("aaaabbbb.ccc");
  relabel(segmentation, record);
  EXPECT_EQ(labels_of(segmentation), (Labels{2, 1, 3}));
  EXPECT_EQ(record.labels.pixels, row_of("aaabbbbbb.cc").pixels);
  EXPECT_EQ(segmentation.bridges[0].label_a, 0);
  EXPECT_EQ(segmentation.bridges[0].label_b, 1);
}

TEST(Relabel, GivesScribbledPartsTheLabelOfTheirNameWhereverTheyLie) {
  const Labels labels = relabelled(segmentation_of("aaaabbbb", {false, true}),
                                   known("aaaabbbb", {{2, "a", CompletionKind::whole}}));
  EXPECT_EQ(labels[0], 2);
  EXPECT_EQ(labels[1], 3) << "label 2 is taken, label 1 lay elsewhere";
}

TEST(Relabel, NeverUsesTheLabelOfAKnownPartForAnother) {
  const Labels labels = relabelled(segmentation_of("aabbcc..", {true, true, false}),
                                   known("aa......", {{7, "gone", CompletionKind::whole}}));
  EXPECT_EQ(labels[0], 1);
  EXPECT_EQ(std::set<PartLabel>(labels.begin() + 1, labels.end()), (std::set<PartLabel>{8, 9}));
}

TEST(Relabel, AgainAndAgainChangesNothing) {
  const Segmentation segmentation = segmentation_of("ab.ccab", {true, false, true});
  Segmentation first = segmentation;
  SegmentationRecord record = known("ccbb.aa", {{9, "b", CompletionKind::whole}});
  relabel(first, record);
  EXPECT_EQ(relabelled(segmentation, record), labels_of(first));
}

TEST(Relabel, DropsCorrectionsOfPartsThatAreGoneOrTooSmall) {
  SegmentationRecord record = known("aaabccc");
  Segmentation found = segmentation_of("aaabccc", {true, true, true});
  for (size_t i = 65; i < 80; ++i) record.labels.pixels[i] = found.labels.pixels[i] = 0;
  Corrections& corrections = record.corrections;
  corrections.parts[1].c = 2;
  corrections.parts[2].c = 3;
  corrections.parts[9].c = 3;
  corrections.order = {{1, 3}, {2, 3}};
  corrections.joins = {{3, 1, {}}, {2, 1, {}}};
  corrections.no_joins = {{1, 2}, {1, 3}};
  corrections.cues = {{2, CueKind::bulge, {}, 2}, {3, CueKind::crease, {}, 30}};
  relabel(found, record);
  ASSERT_EQ(corrections.cues.size(), 1u);
  EXPECT_EQ(corrections.cues[0].part, 3);
  EXPECT_EQ(corrections.parts.size(), 1u);
  EXPECT_EQ(corrections.parts.count(1), 1u);
  EXPECT_EQ(corrections.order, (std::vector<std::pair<PartLabel, PartLabel>>{{1, 3}}));
  ASSERT_EQ(corrections.joins.size(), 1u);
  EXPECT_EQ(corrections.joins[0].upper, 3);
  EXPECT_EQ(corrections.no_joins, (std::vector<std::pair<PartLabel, PartLabel>>{{1, 3}}));
}

}  // namespace
}  // namespace relievo::understanding

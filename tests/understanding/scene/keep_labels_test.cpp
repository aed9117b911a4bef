#include <gtest/gtest.h>

#include <set>

#include "understanding/scene/keep_edits.h"

namespace relievo::understanding {
namespace {

/// A row of pixels for each letter of a picture; '.' is background.
Image16 row_of(const std::string& letters) {
  Image16 labels(static_cast<int>(letters.size()), 1, 1);
  for (size_t i = 0; i < letters.size(); ++i)
    labels.pixels[i] =
        letters[i] == '.' ? uint16_t{0} : static_cast<uint16_t>(letters[i] - 'a' + 1);
  return labels;
}

/// `proposed` says it of each label in turn; ids are "a", "b", ...
Segmentation segmentation_of(const std::string& letters, const std::vector<bool>& proposed) {
  Segmentation segmentation;
  segmentation.labels = row_of(letters);
  for (size_t k = 0; k < proposed.size(); ++k) {
    segmentation.parts.emplace_back();
    segmentation.parts.back().id = std::string(1, static_cast<char>('a' + k));
    segmentation.parts.back().proposed = proposed[k];
  }
  return segmentation;
}

TEST(KeepLabels, NumbersFromOneWhereNothingIsKnown) {
  const KeptLabels kept = keep_labels(segmentation_of("aab.bc", {true, true, true}), {});
  EXPECT_EQ(kept.labels.pixels, row_of("aab.bc").pixels);
  EXPECT_EQ(kept.label_of, (std::vector<PartLabel>{1, 2, 3}));
}

TEST(KeepLabels, GivesProposedPartsTheLabelWithWhichTheyShareMost) {
  const KnownParts known{row_of("aaaabbbb.ccc"), {}};
  const KeptLabels kept = keep_labels(segmentation_of("bbbaaaaaa.cc", {true, true, true}), known);
  EXPECT_EQ(kept.label_of, (std::vector<PartLabel>{2, 1, 3}));
  EXPECT_EQ(kept.labels.pixels, row_of("aaabbbbbb.cc").pixels);
}

TEST(KeepLabels, GivesScribbledPartsTheLabelOfTheirNameWhereverTheyLie) {
  const KnownParts known{row_of("aaaabbbb"), {{"a", 2}}};
  const KeptLabels kept = keep_labels(segmentation_of("aaaabbbb", {false, true}), known);
  EXPECT_EQ(kept.label_of[0], 2);
  EXPECT_EQ(kept.label_of[1], 3) << "label 2 is taken, label 1 lay elsewhere";
}

TEST(KeepLabels, NeverUsesTheLabelOfAKnownPartForAnother) {
  const KnownParts known{row_of("aa......"), {{"gone", 7}}};
  const KeptLabels kept = keep_labels(segmentation_of("aabbcc..", {true, true, false}), known);
  EXPECT_EQ(kept.label_of[0], 1);
  EXPECT_EQ(std::set<PartLabel>(kept.label_of.begin() + 1, kept.label_of.end()),
            (std::set<PartLabel>{8, 9}));
}

TEST(KeepLabels, AgainAndAgainChangesNothing) {
  const Segmentation segmentation = segmentation_of("ab.ccab", {true, false, true});
  const KeptLabels first = keep_labels(segmentation, {row_of("ccbb.aa"), {{"b", 9}}});
  const KeptLabels again = keep_labels(segmentation, {first.labels, {{"b", first.label_of[1]}}});
  EXPECT_EQ(again.label_of, first.label_of);
  EXPECT_EQ(again.labels.pixels, first.labels.pixels);
}

TEST(CorrectionsOf, DropsThoseOfPartsThatAreGone) {
  Corrections corrections;
  corrections.parts[1].c = 2;
  corrections.parts[2].c = 3;
  corrections.order = {{1, 3}, {2, 3}};
  corrections.joining.joins = {{3, 1, {}}, {2, 1, {}}};
  corrections.joining.no_joins = {{1, 2}, {1, 3}};
  corrections.cues = {{2, CueKind::bulge, {}, 2}, {3, CueKind::crease, {}, 30}};
  const Corrections kept = corrections_of(row_of("aaabccc"), corrections, 2);
  ASSERT_EQ(kept.cues.size(), 1u);
  EXPECT_EQ(kept.cues[0].part, 3);
  EXPECT_EQ(kept.parts.size(), 1u);
  EXPECT_EQ(kept.parts.count(1), 1u);
  EXPECT_EQ(kept.order, (std::vector<std::pair<PartLabel, PartLabel>>{{1, 3}}));
  ASSERT_EQ(kept.joining.joins.size(), 1u);
  EXPECT_EQ(kept.joining.joins[0].upper, 3);
  EXPECT_EQ(kept.joining.no_joins, (std::vector<std::pair<int, int>>{{1, 3}}));
}

}  // namespace
}  // namespace relievo::understanding

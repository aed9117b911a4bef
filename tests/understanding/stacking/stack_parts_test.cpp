#include "understanding/stacking/stack_parts.h"

#include <gtest/gtest.h>

#include "support/label_maps.h"
#include "understanding/completion/complete_parts.h"

namespace relievo::understanding {
namespace {

using namespace testing;

using Labels = std::vector<PartLabel>;
using LabelPairs = std::vector<std::pair<PartLabel, PartLabel>>;

Stacking stack(const Image16& labels, const LabelPairs& user = {}) {
  const PartRegions regions = find_regions(labels);
  const auto completion = complete_parts(regions, all_others(regions));
  EXPECT_TRUE(completion.ok());
  const auto evidence = compare_neighbours(regions, *completion);
  EXPECT_TRUE(evidence.ok());
  auto stacking = stack_parts(regions, *evidence, user);
  EXPECT_TRUE(stacking.ok());
  return stacking.ok() ? std::move(*stacking) : Stacking();
}

struct Scenery {
  const char* name;
  std::vector<Inside> shapes;  ///< the second one is in front
};

/// Drawings whose order everybody sees.
const std::vector<Scenery>& sceneries() {
  static const std::vector<Scenery> all = {
      {"two discs", {disc(80, 80, 45), disc(135, 80, 40)}},
      {"small disc before a large one", {disc(90, 80, 60), disc(150, 70, 25)}},
      {"leg before a body", {oval(110, 60, 80, 45, 0), box(95, 70, 125, 150)}},
      {"leg behind a body", {box(95, 70, 125, 150), oval(110, 60, 80, 45, 0)}},
      {"head before a neck", {box(90, 70, 130, 150), disc(110, 55, 42)}},
      {"eye on a head", {disc(110, 80, 60), disc(95, 70, 10)}},
      {"ear behind a head", {oval(60, 40, 18, 30, 0.5), disc(110, 85, 60)}},
      {"arm across a chest", {oval(110, 80, 60, 70, 0), box(30, 70, 190, 92)}},
  };
  return all;
}

TEST(StackParts, SeesWhatIsInFront) {
  for (const Scenery& scenery : sceneries()) {
    const Stacking stacking = stack(painted(220, 160, scenery.shapes));
    EXPECT_EQ(stacking.back_to_front, (Labels{1, 2})) << scenery.name;
    ASSERT_EQ(stacking.arrows.size(), 1U) << scenery.name;
    EXPECT_GT(stacking.arrows[0].confidence, 0.15) << scenery.name;
    EXPECT_LE(stacking.arrows[0].confidence, 1) << scenery.name;
  }
}

TEST(StackParts, IsUnsureOfTwoBoxesSideBySide) {
  const Stacking stacking =
      stack(painted(220, 160, {box(30, 40, 110, 120), box(110, 40, 190, 120)}));
  for (const OrderArrow& arrow : stacking.arrows) EXPECT_LT(arrow.confidence, 0.15);
}

Image16 mirrored(const Image16& labels) {
  Image16 image = labels;
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x) image.at(x, y) = labels.at(labels.width - 1 - x, y);
  return image;
}

Image16 renamed(const Image16& labels, int largest) {
  Image16 image = labels;
  for (uint16_t& label : image.pixels)
    if (label > 0) label = static_cast<uint16_t>(10 * (largest + 1 - label));
  return image;
}

TEST(StackParts, DoesNotDependOnMirroringOrNames) {
  for (const Scenery& scenery : sceneries()) {
    const Image16 labels = painted(220, 160, scenery.shapes);
    EXPECT_EQ(stack(mirrored(labels)).back_to_front, (Labels{1, 2})) << scenery.name;
    EXPECT_EQ(stack(renamed(labels, 2)).back_to_front, (Labels{20, 10})) << scenery.name;
  }
}

TEST(StackParts, UserArrowsAreNeverOverruled) {
  for (const Scenery& scenery : sceneries()) {
    const Stacking stacking = stack(painted(220, 160, scenery.shapes), {{1, 2}});
    EXPECT_EQ(stacking.back_to_front, (Labels{2, 1})) << scenery.name;
  }
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Image16 labels = random_labels(seed);
    const Labels parts = find_regions(labels).labels;
    LabelPairs user;
    for (size_t part = 0; part + 1 < parts.size(); ++part)
      user.emplace_back(parts[part], parts[part + 1]);
    EXPECT_EQ(stack(labels, user).back_to_front, Labels(parts.rbegin(), parts.rend()));
  }
}

TEST(Junctions, TheStraightContourIsInFront) {
  // A box in front of the seam between two others: its side runs straight past the seam's end.
  const PartRegions regions = find_regions(
      painted(200, 160, {box(20, 20, 180, 80), box(20, 80, 180, 140), box(60, 40, 100, 120)}));
  int seen = 0;
  for (const OrderArrow& cue : find_junction_cues(regions))
    if (cue.confidence > 0.9 && cue.upper == regions.labels[2]) ++seen;
  EXPECT_GE(seen, 4);
}

TEST(Bulges, TheConvexSideIsInFront) {
  const auto bulges =
      find_bulges(find_regions(painted(200, 160, {box(20, 20, 180, 140), disc(100, 20, 40)})));
  ASSERT_EQ(bulges.size(), 1U);
  EXPECT_EQ(bulges[0].upper, 2);
  EXPECT_GT(bulges[0].confidence, 0.9);
}

}  // namespace
}  // namespace relievo::understanding

#include "understanding/completion/complete_parts.h"

#include <gtest/gtest.h>

#include "kernel/image/components.h"
#include "support/label_maps.h"

namespace relievo::understanding {
namespace {

using namespace testing;

Completion complete(const PartRegions& regions, const Occluders& occluders) {
  auto completion = complete_parts(regions, occluders);
  EXPECT_TRUE(completion.ok());
  return completion.ok() ? std::move(*completion) : Completion();
}

/// Parts with larger labels hide those with smaller ones, as painted() lays them.
Occluders painted_later(int parts) {
  Occluders occluders(parts);
  for (int part = 0; part < parts; ++part)
    for (int other = part + 1; other < parts; ++other) occluders[part].push_back(other);
  return occluders;
}

double overlap_ratio(const Mask& shape, const Inside& truth, const Image16& canvas) {
  double both = 0;
  double either = 0;
  for (int y = 0; y < canvas.height; ++y)
    for (int x = 0; x < canvas.width; ++x) {
      const bool a = shape.has(x, y);
      const bool b = truth(x + 0.5, y + 0.5);
      both += a && b ? 1 : 0;
      either += a || b ? 1 : 0;
    }
  return both / either;
}

TEST(CompleteParts, KeepWhatIsSeenAndStayBelowTheirOccluders) {
  for (unsigned seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(seed);
    const PartRegions regions = find_regions(random_labels(seed));
    const Occluders occluders = painted_later(regions.count());
    const Completion completion = complete(regions, occluders);
    for (int part = 0; part < regions.count(); ++part) {
      const Mask& shape = completion[part].shape;
      for_each_pixel(regions.visible[part], [&](int x, int y) { EXPECT_TRUE(shape.has(x, y)); });
      for_each_pixel(shape, [&](int x, int y) { EXPECT_GE(regions.part_at(x, y), part); });
      EXPECT_EQ(pixel_count(connected_to(shape, regions.visible[part])), pixel_count(shape));
    }
  }
}

TEST(CompleteParts, ClippedToTheOrderTheyStayBelowPartsInFront) {
  for (unsigned seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(seed);
    const PartRegions regions = find_regions(random_labels(seed));
    const int count = regions.count();
    const Completion clipped = clip_to_order(regions, complete(regions, all_others(regions)),
                                             complete(regions, painted_later(count)), 2);
    for (int part = 0; part < count; ++part) {
      const Mask& shape = clipped[part].shape;
      for_each_pixel(regions.visible[part], [&](int x, int y) { EXPECT_TRUE(shape.has(x, y)); });
      for_each_pixel(shape, [&](int x, int y) { EXPECT_GE(regions.part_at(x, y), part); });
    }
  }
}

TEST(CompleteParts, KnownShapesAreKeptWhereTheOccludersAreTheSame) {
  const Image16 labels = painted(220, 160, {disc(80, 80, 45), disc(135, 80, 40)});
  const PartRegions regions = find_regions(labels);
  Completion known = complete(regions, {{1}, {}});
  known[0].shape.add(known[0].shape.left, known[0].shape.top);
  const auto again = complete_parts(regions, {{1}, {}}, {}, {&known});
  ASSERT_TRUE(again.ok());
  EXPECT_EQ((*again)[0].shape.inside.pixels, known[0].shape.inside.pixels);
  const auto anew = complete_parts(regions, {{}, {0}}, {}, {&known});
  ASSERT_TRUE(anew.ok());
  EXPECT_EQ((*anew)[0].kind, CompletionKind::whole);
}

TEST(FindRegions, LeaveTheRimOutUnlessAPartIsTooNarrow) {
  const Image16 labels = painted(120, 120, {disc(60, 60, 40), box(58, 5, 62, 30)});
  const PartRegions regions = find_regions(labels, 3);
  for_each_pixel(regions.visible[0],
                 [&](int x, int y) { EXPECT_LT(std::hypot(x + 0.5 - 60, y + 0.5 - 60), 38); });
  EXPECT_EQ(pixel_count(regions.inked[0]),
            std::count(labels.pixels.begin(), labels.pixels.end(), 1));
  EXPECT_TRUE(regions.visible[1].has(60, 8)) << "the box has no room for a rim";
  EXPECT_EQ(find_regions(labels).map.pixels, labels.pixels);
}

TEST(SortRegions, PutsThePartsInTheOrderOfTheLabels) {
  PartRegions regions = find_regions(painted(120, 120, {disc(60, 60, 40), disc(60, 60, 10)}));
  sort_regions({2, 1}, regions);
  EXPECT_EQ(regions.labels, (std::vector<PartLabel>{2, 1}));
  EXPECT_EQ(regions.part_at(60, 60), 0);
  EXPECT_TRUE(regions.visible[0].has(60, 60));
  EXPECT_EQ(regions.rings[1].front().label, 1);
  EXPECT_EQ(regions.by_label(), (std::vector<int>{1, 0}));
}

TEST(CompleteParts, HiddenDiscBecomesRound) {
  const Inside back = disc(80, 80, 45);
  const Image16 labels = painted(220, 160, {back, disc(135, 80, 40)});
  const Completion completion = complete(find_regions(labels), {{1}, {}});
  EXPECT_EQ(completion[0].kind, CompletionKind::ellipse);
  EXPECT_GE(overlap_ratio(completion[0].shape, back, labels), 0.97);
  EXPECT_EQ(completion[1].kind, CompletionKind::whole);
}

TEST(CompleteParts, HiddenLimbGoesOn) {
  // Only the lower end of a long straight limb is seen: it continues as wide as it is.
  const Image16 labels = painted(200, 220, {box(85, 60, 115, 200), oval(100, 70, 80, 50, 0)});
  const Completion completion = complete(find_regions(labels), {{1}, {}});
  EXPECT_EQ(completion[0].kind, CompletionKind::continuation);
  const Mask& shape = completion[0].shape;
  EXPECT_TRUE(shape.has(100, 112));
  for_each_pixel(shape, [&](int x, int y) {
    EXPECT_GE(x, 83) << y;
    EXPECT_LE(x, 116) << y;
  });
}

TEST(CompleteParts, PiecesOnBothSidesOfAnOccluderAreBridged) {
  // A band behind a disc is seen on both sides of it.
  const Inside band = box(20, 70, 220, 100);
  const Image16 labels = painted(240, 170, {band, disc(120, 85, 28)});
  const Completion completion = complete(find_regions(labels), {{1}, {}});
  EXPECT_EQ(completion[0].kind, CompletionKind::continuation);
  EXPECT_GE(overlap_ratio(completion[0].shape, band, labels), 0.99);
}

TEST(CompleteParts, CapeBehindABodyIsWhole) {
  // Its pieces are to both sides of the body and between the legs.
  const Inside cape = [](double x, double y) {
    const double u = (x - 120) / (55 + 0.15 * (y - 40));
    const double top = 60 - 40 * std::sqrt(std::max(0.0, 1 - u * u));
    return std::abs(u) < 1 && y > top && y < 220;
  };
  const Image16 labels = painted(240, 260,
                                 {cape, box(85, 180, 105, 250), box(135, 180, 155, 250),
                                  oval(120, 125, 50, 80, 0), disc(120, 35, 33)});
  const PartRegions regions = find_regions(labels);
  const Completion completion = complete(regions, painted_later(5));
  EXPECT_EQ(completion[0].kind, CompletionKind::continuation);
  EXPECT_LE(overlap_ratio(regions.visible[0], cape, labels), 0.45);
  EXPECT_GE(overlap_ratio(completion[0].shape, cape, labels), 0.95);
}

TEST(CompleteParts, RingBehindTwoDiscsKeepsItsHole) {
  const Inside ring = [](double x, double y) {
    const double r = std::hypot(x - 100, y - 100);
    return r > 45 && r < 75;
  };
  const Image16 labels = painted(200, 200, {ring, disc(40, 100, 22), disc(160, 110, 22)});
  const Completion completion = complete(find_regions(labels), {{1, 2}, {}, {}});
  EXPECT_EQ(completion[0].kind, CompletionKind::continuation);
  EXPECT_GE(overlap_ratio(completion[0].shape, ring, labels), 0.98);
}

TEST(CompleteParts, SquareBehindALatticeHasAllBetweenItsPieces) {
  const Inside square = box(30, 30, 170, 170);
  const Inside lattice = [](double x, double y) {
    const auto bar = [](double t) { return std::abs(std::abs(t - 100) - 25) < 15; };
    return bar(x) || bar(y);
  };
  const Image16 labels = painted(200, 200, {square, lattice});
  const Completion completion = complete(find_regions(labels), {{1}, {}});
  EXPECT_EQ(completion[0].kind, CompletionKind::membrane);
  EXPECT_GE(overlap_ratio(completion[0].shape, square, labels), 0.98);
}

TEST(CompleteParts, MembraneEndsWhereContoursDriftApart) {
  // A strip that widens below a large part, as a waistband below a shirt: its sides never meet.
  const Inside strip = [](double x, double y) {
    return y > 100 && y < 112 && std::abs(x - 150) < 40 + 2 * (112 - y);
  };
  const Image16 labels = painted(300, 160, {strip, box(20, 5, 280, 100)});
  const PartRegions regions = find_regions(labels);
  const Completion completion = complete(regions, {{1}, {}});
  ASSERT_EQ(completion[0].kind, CompletionKind::membrane);
  const Mask& shape = completion[0].shape;
  const int width = regions.visible[0].inside.width;
  EXPECT_TRUE(shape.has(150, 95));
  for_each_pixel(shape, [&](int x, int y) {
    EXPECT_GT(y, 100 - 0.26 * width) << x;
    EXPECT_LT(std::abs(x - 150), 0.77 * width) << y;
  });
}

TEST(CompleteParts, EnclosedFeatureHidesWhatIsBelowIt) {
  const Image16 labels = painted(160, 160, {disc(80, 80, 60), disc(60, 70, 12)});
  const Completion completion = complete(find_regions(labels), {{1}, {}});
  EXPECT_TRUE(completion[0].shape.has(60, 70));
  EXPECT_EQ(completion[1].kind, CompletionKind::whole);
}

TEST(CompareNeighbours, TellWhoseContourTheBoundaryIs) {
  const PartRegions regions =
      find_regions(painted(220, 160, {disc(80, 80, 45), disc(135, 80, 40)}));
  const auto evidence = compare_neighbours(regions, complete(regions, all_others(regions)));
  ASSERT_TRUE(evidence.ok());
  ASSERT_EQ(evidence->size(), 1U);
  const NeighbourEvidence& pair = evidence->front();
  EXPECT_FALSE(pair.a_shaped);
  EXPECT_TRUE(pair.b_shaped);
  EXPECT_GT(pair.a_below_b, pair.b_below_a);
}

}  // namespace
}  // namespace relievo::understanding

#include "understanding/joins/part_profile.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/label_maps.h"
#include "understanding/completion/part_regions.h"

namespace relievo::understanding {
namespace {

using namespace testing;

using Joins = std::vector<ProposedJoin>;

/// Which of the shapes, painted back to front and known where hidden too, are backdrops.
std::vector<uint8_t> backdrops_of(const std::vector<Inside>& shapes, const Joins& joins = {}) {
  Completion completion;
  for (const Inside& shape : shapes)
    completion.push_back(
        {find_regions(painted(300, 300, {shape})).visible[0], CompletionKind::whole, {}});
  return find_backdrops(find_regions(painted(300, 300, shapes)), completion, joins);
}

using Flags = std::vector<uint8_t>;

const Inside cape = oval(150, 190, 75, 85, 0);
const Inside trunk = oval(150, 170, 60, 90, 0);
const Inside head = oval(150, 60, 55, 45, 0);

ProposedJoin joined(int upper, int lower) {
  ProposedJoin proposed;
  proposed.join.upper = upper;
  proposed.join.lower = lower;
  return proposed;
}

TEST(FindBackdrops, ACapeAroundTheTrunkIsOne) {
  EXPECT_EQ(backdrops_of({cape, trunk, head}), (Flags{1, 0, 0}));
}

TEST(FindBackdrops, ATrunkBehindItsArmsIsNone) {
  const Inside left = oval(95, 165, 20, 60, 0.1);
  const Inside right = oval(205, 165, 20, 60, -0.1);
  EXPECT_EQ(backdrops_of({trunk, left, right, head}), (Flags{0, 0, 0, 0}));
}

TEST(FindBackdrops, AFarLegIsNone) {
  const Inside leg = oval(150, 250, 14, 45, 0);
  EXPECT_EQ(backdrops_of({leg, trunk, head}), (Flags{0, 0, 0}));
}

TEST(FindBackdrops, HairOutOfWhichAFaceGrowsIsNone) {
  const Inside hair = oval(150, 60, 62, 52, 0);
  EXPECT_EQ(backdrops_of({hair, head, trunk}), (Flags{1, 0, 0}));
  EXPECT_EQ(backdrops_of({hair, head, trunk}, {joined(1, 0)}), (Flags{0, 0, 0}));
  // What grows out of it and lies mostly beside it changes nothing.
  EXPECT_EQ(backdrops_of({hair, head, trunk}, {joined(2, 0)}), (Flags{1, 0, 0}));
}

TEST(FindBackdrops, WhatHasAPartBehindItIsNone) {
  const Inside tail = oval(240, 180, 50, 25, 0);
  EXPECT_EQ(backdrops_of({tail, cape, trunk, head}), (Flags{0, 0, 0, 0}));
}

TEST(FindBackdrops, WhatIsSeenAsThickAsItIsIsNone) {
  EXPECT_EQ(backdrops_of({box(110, 100, 190, 280), disc(150, 120, 90)}), (Flags{0, 0}));
}

TEST(FindBackdrops, NothingChangesWithTheirScaleOrPlace) {
  for (const double scale : {0.5, 0.75, 1.0}) {
    const auto put = [&](double x, double y, double a, double b) {
      return oval(20 + scale * x, 10 + scale * y, scale * a, scale * b, 0);
    };
    EXPECT_EQ(backdrops_of({put(130, 190, 75, 85), put(130, 170, 60, 90), put(130, 60, 55, 45)}),
              (Flags{1, 0, 0}))
        << scale;
  }
}

TEST(FindBackdrops, NothingHasNone) { EXPECT_TRUE(backdrops_of({}).empty()); }

}  // namespace
}  // namespace relievo::understanding

#include "understanding/joins/propose_joins.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/image/outlines.h"
#include "support/label_maps.h"

namespace relievo::understanding {
namespace {

using namespace testing;

struct Drawing {
  int width;
  int height;
  std::vector<Inside> shapes;
};

/// Joins with the painted order, of that confidence: part k is in front of part k - 1, and
/// completed.
JoinProposals join(const Drawing& drawing, const Corrections& corrections = {},
                   const DrawingEvidence& evidence = {}, double sure = 1) {
  const PartRegions regions = find_regions(painted(drawing.width, drawing.height, drawing.shapes));
  std::vector<Outline> outlines;
  for (int part = 0; part < regions.count(); ++part) {
    const Image16 alone = painted(drawing.width, drawing.height, {drawing.shapes[part]});
    outlines.push_back(outline_of(find_regions(alone).visible[0]));
  }
  std::vector<OrderArrow> order;
  for (int upper = 0; upper < regions.count(); ++upper)
    for (int lower = 0; lower < upper; ++lower)
      order.push_back({regions.labels[upper], regions.labels[lower], sure});
  return propose_joins(regions, outlines, order, corrections, evidence);
}

Drawing leg_on_body() { return {220, 200, {box(20, 20, 200, 100), box(90, 60, 130, 180)}}; }

TEST(JoinParts, TheRootOfALimbIsJoinedAlongItsCap) {
  const JoinProposals joining = join(leg_on_body());
  ASSERT_EQ(joining.joins.size(), 1U);
  const Join& found = joining.joins[0].join;
  EXPECT_EQ(found.upper, 1);
  EXPECT_EQ(found.lower, 0);
  for (const Point2 p : found.line) EXPECT_LT(p.y, 80);
  EXPECT_TRUE(joining.robin.empty());
}

/// Most of a hat lies on the head, so that its outline shows no limb.
TEST(JoinParts, WhatIsNoLimbIsJoinedAlongItsBorder) {
  const JoinProposals joining = join({220, 200, {box(20, 20, 200, 110), box(90, 30, 130, 117)}});
  ASSERT_EQ(joining.joins.size(), 1U);
  const Join& found = joining.joins[0].join;
  // It runs along the top, and the ramps down the sides to where the part leaves the other.
  for (const Point2 p : found.line) EXPECT_LT(p.y, 80);
  ASSERT_EQ(joining.robin.size(), 2U);
  for (const RobinRange& range : joining.robin) {
    EXPECT_NEAR(range.to.y, 110, 1.5);
    EXPECT_LT(range.from.y, range.to.y - 10);
    EXPECT_NEAR(range.from.x, range.to.x, 1.5);
  }
  EXPECT_NEAR(std::abs(joining.robin[0].to.x - joining.robin[1].to.x), 40, 2);
}

TEST(JoinParts, BodyOverAFarArmIsNotJoined) {
  const JoinProposals thin = join({400, 300, {box(20, 80, 60, 220), box(50, 10, 350, 290)}});
  EXPECT_TRUE(thin.joins.empty());
  ASSERT_EQ(thin.relations.size(), 1U);
  EXPECT_EQ(thin.relations[0].relation.kind, RelationKind::joined) << "it touches the outline";
  // Of a lower part that is not much smaller the upper one may be the continuation.
  const JoinProposals wide = join({400, 300, {box(5, 20, 60, 280), box(50, 10, 350, 290)}});
  EXPECT_EQ(wide.joins.size(), 1U);
}

TEST(JoinParts, AnotherColourHalvesTheConfidence) {
  const Drawing hat{220, 200, {box(20, 20, 200, 110), box(90, 30, 130, 117)}};
  const auto confidence = [&](std::array<double, 3> leg) {
    DrawingEvidence evidence;
    evidence.colours = {{255, 255, 255}, {200, 150, 120}, leg};
    return join(hat, {}, evidence).joins.at(0).confidence;
  };
  const double plain = join(hat).joins.at(0).confidence;
  EXPECT_EQ(confidence({200, 150, 120}), plain);
  EXPECT_EQ(confidence({180, 130, 110}), plain) << "a shade";
  EXPECT_NEAR(confidence({130, 150, 120}), 0.75 * plain, 1e-12);
  EXPECT_NEAR(confidence({20, 20, 200}), 0.5 * plain, 1e-12);
}

TEST(JoinParts, AnEnclosedFeatureIsEqual) {
  const JoinProposals joining = join(Drawing{160, 160, {disc(80, 80, 60), disc(60, 70, 12)}});
  EXPECT_TRUE(joining.joins.empty());
  ASSERT_EQ(joining.relations.size(), 1U);
  EXPECT_EQ(joining.relations[0].relation.kind, RelationKind::equal);
}

TEST(JoinParts, WhatCrossesASmallerPartHoldsIt) {
  const JoinProposals joining =
      join(Drawing{220, 160, {box(90, 60, 130, 110), box(20, 60, 200, 100)}});
  EXPECT_TRUE(joining.joins.empty());
  ASSERT_EQ(joining.relations.size(), 1U);
  EXPECT_EQ(joining.relations[0].relation.kind, RelationKind::equal);
}

TEST(JoinParts, ALimbBehindALargePartTouchesItsOutline) {
  const JoinProposals joining =
      join(Drawing{320, 260, {box(150, 200, 166, 240), disc(160, 110, 100)}});
  EXPECT_TRUE(joining.joins.empty());
  ASSERT_EQ(joining.relations.size(), 1U);
  EXPECT_EQ(joining.relations[0].relation.kind, RelationKind::joined);
}

/// A leg comes out from behind a coat, all of it in front of a cape of another colour.
TEST(JoinParts, WhatHangsBehindOnePartIsNotJoinedToABackdrop) {
  const Drawing figure{
      220, 200, {box(20, 20, 200, 170), box(90, 90, 130, 178), box(40, 10, 180, 120)}};
  DrawingEvidence evidence;
  evidence.colours = {{255, 255, 255}, {20, 120, 40}, {150, 90, 60}, {150, 100, 60}};
  const auto joins_of_leg = [](const JoinProposals& joining) {
    return std::count_if(joining.joins.begin(), joining.joins.end(),
                         [](const ProposedJoin& proposed) { return proposed.join.upper == 1; });
  };
  const JoinProposals joining = join(figure, {}, evidence);
  EXPECT_EQ(joins_of_leg(joining), 0);
  const auto of_leg = [&](const ProposedRelation& proposed) {
    return proposed.relation.upper == 2 && proposed.relation.lower == 1 &&
           proposed.relation.kind == RelationKind::joined;
  };
  EXPECT_EQ(std::count_if(joining.relations.begin(), joining.relations.end(), of_leg), 1);

  Corrections apart;
  apart.relations = {{3, 2, RelationKind::above, std::nullopt}};
  EXPECT_EQ(joins_of_leg(join(figure, apart, evidence)), 1) << "it may grow out of the cape";
}

/// A shin is larger than the thigh in front of it, and narrow at the knee.
TEST(JoinParts, WhatNothingHoldsGrowsOutFromBehind) {
  const Drawing leg{
      220, 360, {box(98, 150, 122, 340), box(10, 10, 210, 100), box(90, 60, 130, 155)}};
  const auto kinds_at_knee = [&](const Corrections& corrections) {
    std::vector<RelationKind> kinds;
    for (const ProposedRelation& proposed : join(leg, corrections).relations)
      if (proposed.relation.upper == 2 && proposed.relation.lower == 0)
        kinds.push_back(proposed.relation.kind);
    return kinds;
  };
  EXPECT_EQ(kinds_at_knee({}), (std::vector<RelationKind>{RelationKind::joined}));
  Corrections apart;
  apart.no_joins = {{3, 1}};
  EXPECT_EQ(kinds_at_knee(apart), (std::vector<RelationKind>{RelationKind::above}));
}

/// A thigh lies in front of a lower leg, with which it is not joined.
TEST(JoinParts, APartRisesOnlyWhereTheOrderIsSure) {
  const Drawing leg{
      220, 360, {box(98, 150, 122, 340), box(10, 10, 210, 100), box(90, 60, 130, 155)}};
  Corrections apart;
  apart.no_joins = {{3, 1}};
  const auto kind_at_knee = [&](double sure) {
    for (const ProposedRelation& proposed : join(leg, apart, {}, sure).relations)
      if (proposed.relation.upper == 2 && proposed.relation.lower == 0)
        return proposed.relation.kind;
    return RelationKind::free;
  };
  EXPECT_EQ(kind_at_knee(1), RelationKind::above);
  EXPECT_EQ(kind_at_knee(0.1), RelationKind::equal);
}

TEST(JoinParts, TheUserIsNotOverruled) {
  Corrections none;
  none.no_joins = {{2, 1}};
  EXPECT_TRUE(join(leg_on_body(), none).joins.empty());

  Corrections related;
  related.relations = {{2, 1, RelationKind::free, std::nullopt}};
  const JoinProposals free = join(leg_on_body(), related);
  EXPECT_TRUE(free.joins.empty());
  ASSERT_EQ(free.relations.size(), 1U);
  EXPECT_EQ(free.relations[0].relation.kind, RelationKind::free);

  Corrections drawn;
  drawn.joins = {{2, 1, {{90, 62}, {130, 62}}}};
  const JoinProposals own = join(leg_on_body(), drawn);
  ASSERT_EQ(own.joins.size(), 1U);
  EXPECT_TRUE(own.joins[0].user);
  EXPECT_EQ(own.joins[0].join.line.size(), 2U);

  Corrections ramped;
  ramped.robin = {{2, 1, {90, 70}, {90, 100}, 0.5, std::nullopt}};
  const JoinProposals ramps = join(leg_on_body(), ramped);
  EXPECT_EQ(ramps.joins.size(), 1U);
  ASSERT_EQ(ramps.robin.size(), 1U);
  EXPECT_EQ(ramps.robin[0].alpha0, 0.5);
}

}  // namespace
}  // namespace relievo::understanding

#include "understanding/scene/propose_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "kernel/geometry/polygon.h"
#include "relief/session/build_relief.h"
#include "support/ink_drawing.h"
#include "support/label_maps.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

using namespace testing;

Image16 leg_on_body() {
  return painted(220, 200, {oval(110, 70, 95, 55, 0), box(90, 60, 130, 180)});
}

Proposal propose(const Image16& labels, const Corrections& corrections = {}) {
  auto proposal = propose_scene(labels, corrections);
  EXPECT_TRUE(proposal.ok()) << (proposal.ok() ? "" : to_string(proposal.error()));
  return proposal.ok() ? std::move(*proposal) : Proposal();
}

TEST(ProposeScene, MakesASceneThatBuilds) {
  const Proposal proposal = propose(leg_on_body());
  ASSERT_EQ(proposal.scene.parts.size(), 2U);
  EXPECT_EQ(proposal.scene.parts[1].id, "part-2");
  EXPECT_EQ(proposal.scene.joins.size(), 1U);
  relief::ReliefOptions options;
  options.layers.vertex_budget = 2000;
  const auto relief = relief::build_relief(proposal.scene, options);
  ASSERT_TRUE(relief.ok()) << to_string(relief.error());
  EXPECT_TRUE(relief->layers.warnings.empty());
}

TEST(ProposeScene, RandomDrawingsMakeScenesThatBuild) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    relief::ReliefOptions options;
    options.layers.vertex_budget = 1500;
    const auto relief = relief::build_relief(propose(random_labels(seed)).scene, options);
    EXPECT_TRUE(relief.ok()) << to_string(relief.error());
  }
}

TEST(ProposeScene, RoundPartsAreInflatedMoreThanLongOnes) {
  const Proposal proposal = propose(painted(300, 200, {disc(70, 80, 50), box(150, 80, 290, 100)}));
  const Scene& scene = proposal.scene;
  ASSERT_EQ(scene.parts.size(), 2U);
  const size_t round = scene.parts[0].id == "part-1" ? 0 : 1;
  EXPECT_NEAR(scene.parts[round].c, 4, 0.01);
  EXPECT_NEAR(scene.parts[1 - round].c, 2 * (1 + 20.0 * 20 / (140 * 140)), 0.02);
}

TEST(ProposeScene, TheUserIsNotOverruled) {
  Corrections corrections;
  corrections.order = {{1, 2}};
  corrections.parts[2].id = "leg";
  corrections.parts[2].c = 7;
  corrections.parts[2].d = -2;
  corrections.parts[1].outline = Outline{{{10, 10}, {200, 10}, {200, 120}, {10, 120}}};
  corrections.cues = {{2, CueKind::slope, {{20, 20}, {40, 40}}, 25}};
  const Proposal proposal = propose(leg_on_body(), corrections);
  ASSERT_EQ(proposal.scene.parts.size(), 2U);
  EXPECT_EQ(proposal.scene.parts[0].id, "leg");
  ASSERT_EQ(proposal.scene.cues.size(), 1U);
  EXPECT_EQ(proposal.scene.cues[0].part, 0);
  EXPECT_EQ(proposal.scene.cues[0].value, 25);
  EXPECT_EQ(proposal.scene.parts[0].c, 7);
  EXPECT_EQ(proposal.scene.parts[0].d, -2);
  EXPECT_EQ(proposal.scene.parts[1].outline, *corrections.parts[1].outline);
  EXPECT_EQ(proposal.completion[1].kind, CompletionKind::given);
}

TEST(ProposeScene, NoPartTakesTheNameThatTheUserGaveAnother) {
  Corrections corrections;
  corrections.parts[2].id = "part-1";
  const Proposal proposal = propose(leg_on_body(), corrections);
  std::set<std::string> ids;
  for (const Part& part : proposal.scene.parts) ids.insert(part.id);
  EXPECT_EQ(ids, (std::set<std::string>{"part-1", "part-1-2"}));
}

TEST(ProposeScene, LeansOfTheUserStayAlsoWhereTheyAreNone) {
  const Image16 turned = painted(
      300, 300,
      {oval(95, 140, 15, 50, 0.2), oval(150, 150, 70, 100, 0), oval(205, 140, 15, 50, -0.2)});
  Corrections corrections;
  corrections.order = {{2, 1}, {3, 2}};
  const auto lean_of_body = [&] {
    const Proposal proposal = propose(turned, corrections);
    for (const Part& part : proposal.scene.parts)
      if (part.id == "part-2") return std::pair(part.lean, proposal.joining.leans.size());
    return std::pair(Point2{9, 9}, size_t{9});
  };
  EXPECT_GT(lean_of_body().first.x, 0.1);
  EXPECT_EQ(lean_of_body().second, 1U);
  for (const Point2 said : {Point2{0, 0}, Point2{-0.5, 0.25}}) {
    corrections.parts[2].lean = said;
    EXPECT_EQ(lean_of_body(), std::pair(said, size_t{0}));
  }
}

TEST(ProposeScene, ACapeIsFlatUnlessTheUserSaysOtherwise) {
  const Image16 labels = painted(300, 300, {oval(150, 210, 70, 75, 0), oval(150, 150, 55, 100, 0)});
  const auto cape = [&](const Corrections& corrections) {
    const Proposal proposal = propose(labels, corrections);
    return proposal.scene.parts.at(proposal.regions.part_of(1));
  };
  const Part proposed = cape({});
  EXPECT_EQ(proposed.flat, 1);
  Corrections corrections;
  corrections.parts[1].flat = 0;
  EXPECT_EQ(cape(corrections).flat, 0);
  EXPECT_EQ(cape(corrections).c, proposed.c);
  corrections.parts[1].c = 3;
  EXPECT_EQ(cape(corrections).c, 3);
}

TEST(ProposeScene, AJoinOfTheUserPutsItsPartInFront) {
  Corrections corrections;
  corrections.joins = {{1, 2, {{90, 124}, {130, 124}}}};
  const Proposal proposal = propose(leg_on_body(), corrections);
  EXPECT_EQ(proposal.scene.parts[1].id, "part-1");
  ASSERT_GE(proposal.scene.joins.size(), 1U);
  EXPECT_EQ(proposal.scene.joins[0].upper, 1);
}

/// Mean distance of the points of outlines, sampled evenly, from a curve; points
/// at which `distance_at` is not a number do not count.
template <class DistanceAt>
double mean_distance(const Scene& scene, DistanceAt distance_at) {
  double sum = 0;
  int count = 0;
  for (const Part& part : scene.parts)
    for (const Ring& ring : part.outline) {
      const RingMeasure along = measure(ring);
      for (double s = 0; s < along.length; s += 0.5) {
        const double d = distance_at(point_at(ring, along, s));
        if (std::isnan(d)) continue;
        sum += std::abs(d);
        ++count;
      }
    }
  return sum / count;
}

/// Between parts outlines run along the middle of lines, towards the background along their rim.
TEST(ProposeScene, OutlinesRunAlongLines) {
  const Point2 head{120.2, 90.6};
  const Point2 body{115.6, 190.3};
  for (const double width : {2.0, 3.0, 5.0, 7.0}) {
    // The arc of the body outside the head, in turns.
    const Drawing drawing =
        InkDrawing(240, 290).circle(head, 50, width).arc(body, 70, -0.165, 0.68, width).drawing();
    const auto segmentation = segment_drawing(drawing);
    ASSERT_TRUE(segmentation.ok()) << to_string(segmentation.error());
    const Scene scene = propose(segmentation->labels).scene;
    ASSERT_EQ(scene.parts.size(), 2U);
    const auto from_head = [&](Point2 p) { return distance(p, head) - 50; };
    const auto from_body = [&](Point2 p) { return distance(p, body) - 70; };
    const double between = mean_distance(
        scene, [&](Point2 p) { return from_body(p) > -2 * width ? std::nan("") : from_head(p); });
    EXPECT_LT(between, 0.2) << width;
    const double outside = mean_distance(scene, [&](Point2 p) {
      const bool shared = from_body(p) < 2 * width && from_head(p) < 2 * width;
      if (shared || std::min(from_head(p), from_body(p)) < -3) return std::nan("");
      return std::min(from_head(p), from_body(p)) - width / 2;
    });
    EXPECT_LT(outside, 0.5) << width;
  }
}

TEST(ProposeScene, SaysWhatIsWrong) {
  EXPECT_EQ(propose_scene(Image16(20, 20, 1)).error().code, ErrorCode::bad_input);
  Corrections unknown;
  unknown.order = {{1, 9}};
  const auto missing = propose_scene(leg_on_body(), unknown);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().where, "label 9");
  Corrections circle;
  circle.order = {{1, 2}, {2, 1}};
  EXPECT_EQ(propose_scene(leg_on_body(), circle).error().code, ErrorCode::contradiction);
  Image16 many(4 * 33, 4 * 33, 1);  // squares of 4 x 4 pixels
  for (int y = 0; y < many.height; ++y)
    for (int x = 0; x < many.width; ++x)
      many.at(x, y) = static_cast<uint16_t>(1 + y / 4 * 33 + x / 4);
  EXPECT_EQ(propose_scene(many).error().code, ErrorCode::limit);
}

TEST(ProposeScene, LeavesSpecksOut) {
  Image16 labels = leg_on_body();
  labels.at(3, 3) = 7;
  const Proposal proposal = propose(labels);
  EXPECT_EQ(proposal.scene.parts.size(), 2U);
  EXPECT_EQ(proposal.warnings.size(), 1U);
}

}  // namespace
}  // namespace relievo::understanding

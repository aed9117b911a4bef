#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <set>
#include <string>

#include "research/rivals/measure.h"
#include "research/rivals/rival.h"
#include "research/tests/rival_case.h"
#include "support/random_limbs.h"
#include "support/scenes.h"

namespace relievo::research {
namespace {

Scene one_part(Ring ring) {
  Scene scene = testing::canvas();
  scene.parts = {testing::part("part", std::move(ring))};
  return scene;
}

double height_at(const Model& model, Point2 p) {
  const auto probe = FrontProbe::build(model, {});
  EXPECT_TRUE(probe);
  return probe->height(p).value_or(-1000);
}

TEST(Parabolic, GivesADiscAParaboloidAsHighAsItsSphere) {
  const double radius = 120;
  const Model model = reconstructed(one_part(testing::circle({200, 200}, radius)), "parabolic");
  for (const double r : {0.0, 30.0, 60.0, 90.0, 110.0, 117.0})
    EXPECT_NEAR(height_at(model, {200 + r, 200}), (radius * radius - r * r) / radius, 0.01 * radius)
        << r;
}

TEST(Parabolic, GivesALongStripAParabolaAsHighAsItsEllipse) {
  const double half = 20;
  const Model model =
      reconstructed(one_part(testing::rectangle(20, 200 - half, 380, 200 + half)), "parabolic");
  for (const double y : {0.0, 5.0, 10.0, 15.0, 19.0})
    EXPECT_NEAR(height_at(model, {200, 200 + y}), std::sqrt(2.0) * (half * half - y * y) / half,
                0.01 * half)
        << y;
}

TEST(Parabolic, HasAFiniteSlopeAtTheRimWherePillowsAreSteep) {
  const double radius = 120;
  const Scene scene = one_part(testing::circle({200, 200}, radius));
  const Model parabolic = reconstructed(scene, "parabolic");
  const Model pillow = reconstructed(scene, "pillows");
  for (const double inside : {0.5, 0.25, 0.125}) {
    const Point2 p{200 + radius - inside, 200};
    EXPECT_NEAR(height_at(parabolic, p) / inside, 2, 0.2) << inside;
    EXPECT_GT(height_at(pillow, p) / inside, 10) << inside;
  }
}

TEST(Parabolic, FollowsTheSignAndSizeOfDepthScales) {
  Scene scene = one_part(testing::circle({200, 200}, 120));
  const double high = height_at(reconstructed(scene, "parabolic"), {200, 200});
  scene.parts[0].d = -0.5;
  EXPECT_NEAR(height_at(reconstructed(scene, "parabolic"), {200, 200}), -0.5 * high, 0.01);
}

TEST(InkAndRay, IsPillowsWhereNothingIsJoined) {
  Scene scene = testing::body_and_leg();
  scene.joins.clear();
  const Model pillows = reconstructed(scene, "pillows");
  const Model other = reconstructed(scene, "ink-and-ray");
  EXPECT_EQ(pillows.positions, other.positions);
  EXPECT_EQ(pillows.normals, other.normals);
  EXPECT_EQ(pillows.triangles, other.triangles);
}

TEST(InkAndRay, WithoutAGraftMeetsTheLowerPartWithAKink) {
  RivalOptions none;
  none.graft = 0;
  const Model model = reconstructed(testing::body_and_leg(), "ink-and-ray", none);
  const auto probe = FrontProbe::build(model, {});
  ASSERT_TRUE(probe);
  EXPECT_NEAR(*probe->height({200, 159.9}), *probe->height({200, 160.1}), 0.5);
  const double body = *probe->height({200, 159}) - *probe->height({200, 155});
  const double leg = *probe->height({200, 165}) - *probe->height({200, 161});
  EXPECT_GT(std::abs(leg - body), 0.3);
}

TEST(InkAndRay, GraftsWhatIsBrushedAndNothingElse) {
  const Scene scene = testing::body_and_leg();
  RivalOptions brushed;
  brushed.graft_mask = Image8(400, 400, 4);
  const Model untouched = reconstructed(scene, "ink-and-ray", brushed);
  for (int y = 140; y < 180; ++y)
    for (int x = 0; x < 400; ++x) brushed.graft_mask.at(x, y) = 255;
  const Model grafted = reconstructed(scene, "ink-and-ray", brushed);
  EXPECT_NEAR(height_at(untouched, {200, 200}), height_at(grafted, {200, 200}), 1e-6);
  EXPECT_GT(std::abs(height_at(untouched, {200, 160}) - height_at(grafted, {200, 160})), 0.1);
}

TEST(FirmEnds, LiesBelowOursWhereTheJoinEnds) {
  const Scene scene = testing::body_and_leg();
  const Point2 end{182, 166};
  EXPECT_LT(height_at(reconstructed(scene, "firm-ends"), end),
            height_at(reconstructed(scene, "relievo"), end) - 3);
}

TEST(Entem, MakesABallOfADisc) {
  const double radius = 80;
  const Model model = reconstructed(one_part(testing::circle({200, 200}, radius)), "entem");
  ASSERT_FALSE(model.positions.empty());
  for (const Point3 p : model.positions)
    EXPECT_NEAR(norm(p - Point3{200, 200, 0}), radius, 0.01 * radius);
}

TEST(Entem, MakesARoundTubeOfAStripThatEndsWithIt) {
  Ring ring = testing::capsule({100, 200}, 0, 200, 20);
  const Model model = reconstructed(one_part(ring), "entem");
  EXPECT_NEAR(height_at(model, {200, 200}), 20, 0.5);
  double left = 1000;
  double right = 0;
  for (const Point3 p : model.positions) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
  }
  EXPECT_NEAR(left, 80, 1.5);
  EXPECT_NEAR(right, 320, 1.5);
}

TEST(Entem, BulgesWhereALimbJoinsThatOursContinues) {
  const Scene scene = testing::body_and_leg();
  const auto outside = [&](const char* method) {
    const Model model = reconstructed(scene, method);
    const auto probe = FrontProbe::build(model, {});
    int count = 0;
    for (double y = 221; y < 240; y += 2)
      for (const double x : {174.0, 176.0, 178.0, 222.0, 224.0, 226.0})
        count += probe->height({x, y}) ? 1 : 0;
    return count;
  };
  EXPECT_EQ(outside("relievo"), 0);
  EXPECT_GT(outside("entem"), 2);
}

/// CGAL's surface mesher orders facets by their addresses, so that last digits differ.
void expect_same(const Model& model, const Model& again, const char* name) {
  ASSERT_EQ(model.positions.size(), again.positions.size()) << name;
  for (size_t v = 0; v < model.positions.size(); ++v)
    EXPECT_LT(norm(model.positions[v] - again.positions[v]), 1e-5) << name;
}

TEST(Rivals, AreNamedOnceAndGiveSoundModels) {
  std::set<std::string> names;
  const Scene scene = testing::random_limbs(3);
  for (const Rival& rival : rivals()) {
    EXPECT_TRUE(names.insert(rival.name).second) << rival.name;
    EXPECT_FALSE(std::string(rival.source).empty());
    EXPECT_EQ(find_rival(rival.name), &rival);
    const Model model = reconstructed(scene, rival.name, {}, 3000);
    EXPECT_FALSE(model.triangles.empty()) << rival.name;
    for (const Point3 p : model.positions) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
    for (const Point3 n : model.normals) EXPECT_NEAR(norm(n), 1, 1e-6) << rival.name;
    expect_same(model, reconstructed(scene, rival.name, {}, 3000), rival.name);
  }
  EXPECT_EQ(find_rival("unheard-of"), nullptr);
}

TEST(Rivals, StopWhenCancelled) {
  const Scene scene = testing::body_and_leg();
  const relief::LayeredMesh joined = layered(scene);
  const std::atomic<bool> cancel = true;
  for (const Rival& rival : rivals()) {
    const auto model = rival.reconstruct({scene, joined, {}}, RunContext{&cancel, {}, {}, {}});
    ASSERT_FALSE(model) << rival.name;
    EXPECT_EQ(model.error().code, ErrorCode::interrupted) << rival.name;
  }
}

}  // namespace
}  // namespace relievo::research

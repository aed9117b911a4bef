#include "research/rivals/measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "research/tests/rival_case.h"
#include "support/scenes.h"

namespace relievo::research {
namespace {

/// A vertical grid of heights over the canvas of `scene`.
template <class Height>
Model graph_of(const Scene& scene, Height height) {
  Model model;
  model.width = scene.width;
  model.height = scene.height;
  constexpr int cells = 400;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) {
      const Point2 p{scene.width * x / cells, scene.height * y / cells};
      model.positions.push_back({p.x, scene.height - p.y, height(p)});
      model.normals.push_back({0, 0, 1});
    }
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const int a = y * (cells + 1) + x;
      model.triangles.push_back({a, a + cells + 1, a + 1});
      model.triangles.push_back({a + 1, a + cells + 1, a + cells + 2});
    }
  return model;
}

Measures measured(const Scene& scene, const Model& model) {
  const auto measures = measure(model, layered(scene), 400);
  EXPECT_TRUE(measures);
  return *measures;
}

TEST(Measure, FindsTheSlopeAndTheStepAtAJoin) {
  const Scene scene = testing::body_and_leg();  // its join lies at y = 160
  const Measures flat = measured(scene, graph_of(scene, [](Point2 p) { return 0.3 * p.y; }));
  ASSERT_FALSE(flat.slope_jumps.empty());
  EXPECT_NEAR(flat.slope_jumps.back(), 0, 1e-3);
  EXPECT_NEAR(flat.height_jumps.back(), 0, 1e-3);
  const Measures roof =
      measured(scene, graph_of(scene, [](Point2 p) { return std::abs(p.y - 160); }));
  EXPECT_NEAR(roof.slope_jumps.front(), 90, 1);
  const Measures smooth =
      measured(scene, graph_of(scene, [](Point2 p) { return 0.01 * (p.y - 160) * (p.y - 160); }));
  EXPECT_NEAR(smooth.slope_jumps.back(), 0, 0.5);
  const Measures step =
      measured(scene, graph_of(scene, [](Point2 p) { return p.y > 160.5 ? 7.0 : 0.0; }));
  EXPECT_NEAR(step.height_jumps.front(), 7, 1.5);
}

TEST(Measure, FindsPitsAtTheEndsOfAJoin) {
  const Scene scene = testing::body_and_leg();
  const auto dent = [](Point2 p) {
    return -4 * std::exp(-std::pow(distance(p, {180, 160}) / 4, 2));
  };
  const Measures measures = measured(scene, graph_of(scene, dent));
  ASSERT_EQ(measures.pits.size(), 2U);
  EXPECT_NEAR(measures.pits.back(), 4.0 / 40, 0.01);
  EXPECT_NEAR(measures.pits.front(), 0, 0.002);
}

TEST(Measure, ComparesSilhouettes) {
  Scene scene = testing::canvas();
  scene.parts = {testing::part("square", testing::rectangle(100, 100, 300, 300))};
  const Model whole = graph_of(scene, [](Point2) { return 0.0; });
  EXPECT_NEAR(measured(scene, whole).contour_iou, 0.25, 0.01);
  EXPECT_NEAR(measured(scene, reconstructed(scene, "relievo")).contour_iou, 1, 1e-3);
}

TEST(Measure, TellsPillowsAndFirmEndsFromOurs) {
  const Scene scene = testing::body_and_leg();
  const Measures ours = measured(scene, reconstructed(scene, "relievo"));
  const Measures pillows = measured(scene, reconstructed(scene, "pillows"));
  const Measures firm = measured(scene, reconstructed(scene, "firm-ends"));
  EXPECT_LT(quantile(ours.slope_jumps, 0.5), 3);
  EXPECT_GT(quantile(pillows.slope_jumps, 0.5), 30);
  EXPECT_LT(quantile(ours.pits, 1), 0.02);
  EXPECT_GT(quantile(firm.pits, 1), 0.05);
}

TEST(Measure, QuantilesAreOfTheSortedValues) {
  EXPECT_EQ(quantile({}, 0.5), 0);
  EXPECT_EQ(quantile({1, 2, 4}, 0.5), 2);
  EXPECT_EQ(quantile({1, 2, 4}, 1), 4);
}

}  // namespace
}  // namespace relievo::research

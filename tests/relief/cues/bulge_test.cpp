#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "relief/cues/cue_fields.h"
#include "relief/inflation/inflate.h"
#include "support/scenes.h"
#include "support/solve_once.h"
#include "support/stacked_parts.h"

namespace relievo::relief {
namespace {

constexpr double radius = 200;

LayeredMesh disc(int rings) {
  return stack_parts(testing::disc_mesh(radius, rings), {[](int, Point2) { return true; }});
}

std::vector<Point2> closed_circle(double r) {
  std::vector<Point2> line = testing::circle({0, 0}, r, 120);
  line.push_back(line.front());
  return line;
}

Scene with_ring(const LayeredMesh& mesh, double r, double value) {
  Scene scene = testing::scene_of(mesh);
  scene.cues = {{0, CueKind::bulge, closed_circle(r), value}};
  return scene;
}

double height_at_centre(const LayeredMesh& mesh, const Scene& scene) {
  const Result<Inflation> inflation = inflate(mesh, scene, {});
  EXPECT_TRUE(inflation) << to_string(inflation.error());
  double highest = 0;
  for (const double u : inflation->u) highest = std::max(highest, u);
  return std::sqrt(highest);
}

TEST(Bulge, NoBulgeGivesNoFactors) {
  const LayeredMesh mesh = disc(8);
  Scene scene = testing::scene_of(mesh);
  scene.cues = {{0, CueKind::slope, {{0, 0}, {9, 9}}, 20}};
  EXPECT_TRUE(bulge_factors(mesh, scene).empty());
}

TEST(Bulge, ValueOneChangesNothing) {
  const LayeredMesh mesh = disc(16);
  for (const double factor : bulge_factors(mesh, with_ring(mesh, 90, 1)))
    EXPECT_NEAR(factor, 1, 1e-12);
}

/// b is constant within a ring and falls with the logarithm of the radius beyond it.
TEST(Bulge, ARingOnADiscMatchesTheHarmonicFunction) {
  double last_error = 1;
  for (const int rings : {12, 24, 48}) {
    const LayeredMesh mesh = disc(rings);
    const double ring = 80;
    const std::vector<double> factors = bulge_factors(mesh, with_ring(mesh, ring, 2));
    double error = 0;
    for (size_t f = 0; f < factors.size(); ++f) {
      const double r = norm(testing::middle_of_face(mesh, static_cast<int>(f)));
      const double b = r <= ring ? 2 : 1 + std::log(radius / r) / std::log(radius / ring);
      error = std::max(error, std::abs(std::sqrt(factors[f]) - b));
    }
    EXPECT_LE(error, 0.8 * last_error) << rings;
    EXPECT_LE(error, 6.0 / rings);
    last_error = error;
  }
}

/// At the centre u is the integral of c b^2 r log(R / r), by the Green's function of the disc.
TEST(Bulge, TheHeightFollowsFromTheSource) {
  const LayeredMesh mesh = disc(64);
  const double ring = 80;
  double u = 0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double r = radius * (i + 0.5) / steps;
    const double b = r <= ring ? 2 : 1 + std::log(radius / r) / std::log(radius / ring);
    u += 4 * b * b * r * std::log(radius / r) * radius / steps;
  }
  EXPECT_NEAR(height_at_centre(mesh, with_ring(mesh, ring, 2)), std::sqrt(u), 0.02 * radius);
}

TEST(Bulge, StrokesEverywhereScaleHeights) {
  const LayeredMesh mesh = disc(48);
  const double plain = height_at_centre(mesh, testing::scene_of(mesh));
  for (const double value : {0.5, 3.0}) {
    Scene scene = testing::scene_of(mesh);
    for (int i = 0; i < 48; ++i)
      scene.cues.push_back({0, CueKind::bulge, closed_circle(radius * (i + 0.5) / 48), value});
    EXPECT_NEAR(height_at_centre(mesh, scene) / plain, value, 0.02 * value);
  }
}

TEST(Bulge, ActsOnItsOwnPartAlone) {
  const LayeredMesh mesh =
      stack_parts(testing::grid_mesh(40, 20, 5),
                  {testing::in_box({0, 0}, {100, 100}), testing::in_box({60, 20}, {180, 80})});
  Scene scene = testing::scene_of(mesh);
  scene.cues = {{1, CueKind::bulge, {{70, 50}, {170, 50}}, 2}};
  const std::vector<double> factors = bulge_factors(mesh, scene);
  double most = 0;
  for (size_t f = 0; f < factors.size(); ++f) {
    if (mesh.face_part[f] == 0) {
      EXPECT_EQ(factors[f], 1);
    }
    most = std::max(most, factors[f]);
  }
  EXPECT_NEAR(most, 4, 1e-9);
}

}  // namespace
}  // namespace relievo::relief

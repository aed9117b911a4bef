#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "relief/cues/cue_fields.h"
#include "relief/inflation/inflate.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/order_depth.h"
#include "relief/ordering/shift_metric.h"
#include "support/solve_once.h"
#include "support/stacked_parts.h"

namespace relievo::relief {
namespace {

using testing::in_box;
using testing::in_disc;

double tangent(double degrees) { return std::tan(degrees * M_PI / 180); }

testing::PlanarMesh turned(testing::PlanarMesh mesh, double angle) {
  for (Point2& p : mesh.vertices)
    p = {std::cos(angle) * p.x - std::sin(angle) * p.y,
         std::sin(angle) * p.x + std::cos(angle) * p.y};
  return mesh;
}

LayeredMesh two_discs() {
  return stack_parts(testing::jittered(testing::grid_mesh(50, 50, 8), 2),
                     {in_disc({150, 150}, 120), in_disc({230, 230}, 140)});
}

Ordering ordered(const LayeredMesh& mesh, const Scene& scene) {
  const Result<Inflation> inflation = inflate(mesh, scene, {});
  EXPECT_TRUE(inflation) << to_string(inflation.error());
  const Result<Ordering> ordering = order_depth(mesh, *inflation, scene, {});
  EXPECT_TRUE(ordering) << to_string(ordering.error());
  return *ordering;
}

TEST(Slope, ASingleSlopeEqualsALean) {
  const LayeredMesh mesh = two_discs();
  Scene arrow = testing::scene_of(mesh);
  arrow.cues = {{1, CueKind::slope, {{200, 200}, {230, 240}}, 25}};
  Scene lean = testing::scene_of(mesh);
  lean.parts[1].lean = tangent(25) * Point2{0.6, 0.8};
  const SlopeField field = slope_field(mesh, arrow, 1);
  for (size_t f = 0; f < field.slope.size(); ++f)
    EXPECT_LE(norm(field.slope[f] - lean.parts[mesh.face_part[f]].lean), 1e-12);
  ShiftMetric a = make_shift_metric(discretise(mesh), 1e-4);
  ShiftMetric b = a;
  set_slopes(mesh, arrow, 1e-4, a);
  set_slopes(mesh, lean, 1e-4, b);
  EXPECT_LE((a.b - b.b).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_NEAR(a.constant, b.constant, 1e-12);
  const Ordering with_arrow = ordered(mesh, arrow);
  const Ordering with_lean = ordered(mesh, lean);
  for (size_t n = 0; n < with_lean.h.size(); ++n)
    EXPECT_NEAR(with_arrow.h[n], with_lean.h[n], 1e-7);
}

TEST(Slope, AddsToTheLeanOfItsPart) {
  const LayeredMesh mesh = two_discs();
  Scene scene = testing::scene_of(mesh);
  scene.parts[0].lean = {0.1, -0.2};
  scene.cues = {{0, CueKind::slope, {{100, 150}, {180, 150}}, 45}};
  const SlopeField field = slope_field(mesh, scene, 1);
  for (size_t f = 0; f < field.slope.size(); ++f) {
    const Point2 expected = mesh.face_part[f] == 0 ? Point2{1.1, -0.2} : Point2{};
    EXPECT_LE(norm(field.slope[f] - expected), 1e-12);
  }
}

/// Between two lines across a strip the field is linear, beyond them it is constant.
TEST(Slope, IsHarmonicBetweenArrows) {
  const LayeredMesh mesh = stack_parts(testing::grid_mesh(120, 20, 2), {in_box({0, 0}, {240, 40})});
  Scene scene = testing::scene_of(mesh);
  // The lines lie just beside columns of vertices, so that each meets one column of triangles.
  scene.cues = {{0, CueKind::slope, {{61, 0}, {61, 40}}, 10},
                {0, CueKind::slope, {{181, 0}, {181, 40}}, 50}};
  const SlopeField field = slope_field(mesh, scene, 1);
  for (size_t f = 0; f < field.slope.size(); ++f) {
    const double t = std::clamp(
        (testing::middle_of_face(mesh, static_cast<int>(f)).x - 62) / (180 - 62), 0.0, 1.0);
    EXPECT_NEAR(field.slope[f].x, 0, 1e-12);
    EXPECT_NEAR(field.slope[f].y, (1 - t) * tangent(10) + t * tangent(50), 1e-9);
  }
}

TEST(Slope, TurnsWithTheDrawing) {
  const testing::PlanarMesh base = testing::jittered(testing::grid_mesh(30, 30, 10), 3);
  const double angle = 0.7;
  const auto all = [](int, Point2) { return true; };
  const LayeredMesh mesh = stack_parts(base, {all});
  const LayeredMesh rotated = stack_parts(turned(base, angle), {all});
  const auto at = [&](Point2 p, double by) { return turned({{p}, {}}, by).vertices[0]; };
  Scene scene = testing::scene_of(mesh);
  scene.cues = {{0, CueKind::slope, {{51.3, 60.2}, {120.7, 71.9}, {130.1, 160.4}}, 30},
                {0, CueKind::slope, {{250.9, 240.1}, {200.3, 251.7}}, -15}};
  Scene other = scene;
  for (Cue& cue : other.cues)
    for (Point2& p : cue.line) p = at(p, angle);
  const SlopeField a = slope_field(mesh, scene, 1);
  const SlopeField b = slope_field(rotated, other, 1);
  for (size_t f = 0; f < a.slope.size(); ++f) {
    EXPECT_LE(norm(at(a.slope[f], angle) - b.slope[f]), 1e-9);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a.rise[f][k], b.rise[f][k], 1e-7);
  }
}

/// The rise is optimal: the divergence of v less its gradient is 0.
TEST(Slope, APartAloneTakesTheNearestRise) {
  const LayeredMesh mesh =
      stack_parts(testing::jittered(testing::grid_mesh(40, 40, 10), 3), {in_disc({200, 200}, 170)});
  Scene scene = testing::scene_of(mesh);
  scene.cues = {{0, CueKind::slope, {{100, 150}, {180, 180}}, 40},
                {0, CueKind::slope, {{220, 300}, {250, 220}}, 20}};
  const Ordering ordering = ordered(mesh, scene);
  const SlopeField field = slope_field(mesh, scene, 1);
  const size_t f0 = 0;
  const double offset = ordering.g[mesh.faces[f0][0]] - field.rise[f0][0];
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(ordering.g[mesh.faces[f][k]] - field.rise[f][k], offset, 1e-6);
}

/// A leg slopes on a body that does not: the slope is 0 at the join, without a kink.
TEST(Slope, FadesTowardsJoins) {
  LayeredMesh mesh = stack_parts(testing::grid_mesh(50, 45, 4),
                                 {in_box({0, 0}, {200, 120}), in_box({80, 80}, {120, 180})});
  testing::join_parts(mesh, 1, 0, [](Point2 p) { return p.y == 80 && p.x >= 80 && p.x <= 120; });
  Scene scene = testing::scene_of(mesh);
  scene.cues = {{1, CueKind::slope, {{100, 165}, {100, 178}}, 45}};
  const SlopeField field = slope_field(mesh, scene, 1);
  double at_seam = 0;
  double at_end = 0;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.face_part[f] == 0) {
      EXPECT_EQ(norm(field.slope[f]), 0);
      continue;
    }
    if (testing::middle_of_face(mesh, static_cast<int>(f)).y < 84)
      at_seam = std::max(at_seam, norm(field.slope[f]));
    if (testing::middle_of_face(mesh, static_cast<int>(f)).y > 170)
      at_end = std::max(at_end, norm(field.slope[f]));
  }
  EXPECT_LE(at_seam, 4.0 / 80);
  EXPECT_NEAR(at_end, 1, 1e-9);
}

TEST(Slope, HasNoEffectOutsideItsPart) {
  const LayeredMesh mesh = two_discs();
  Scene scene = testing::scene_of(mesh);
  scene.cues = {{0, CueKind::slope, {{350, 350}, {360, 390}}, 45}};
  for (const Point2 slope : slope_field(mesh, scene, 1).slope) EXPECT_EQ(slope, Point2{});
}

}  // namespace
}  // namespace relievo::relief

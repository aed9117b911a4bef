#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/probe.h"
#include "support/random_scene.h"

namespace relievo::relief {
namespace {

using namespace testing;

/// Edges are short enough for straight limbs: a part is glued up to one edge before its exit, so
/// that its height depends on the length of edges.
constexpr int many_vertices = 24000;

Relief build(const Scene& scene, Method method, int vertices = 6000) {
  ReliefOptions options;
  options.method = method;
  options.layers.vertex_budget = vertices;
  return relief_of(scene, options);
}

class Invariance : public ::testing::TestWithParam<Method> {};
class Determinism : public ::testing::TestWithParam<Method> {};

std::string method_name(const ::testing::TestParamInfo<Method>& info) {
  return info.param == Method::nonlinear ? "nonlinear" : "approximate";
}

INSTANTIATE_TEST_SUITE_P(Of, Invariance, ::testing::Values(Method::approximate, Method::nonlinear),
                         method_name);
INSTANTIATE_TEST_SUITE_P(Of, Determinism, ::testing::Values(Method::approximate, Method::nonlinear),
                         method_name);

template <class Map>
Scene mapped(Scene scene, Map map) {
  for (Part& part : scene.parts)
    for (Ring& ring : part.outline)
      for (Point2& p : ring) p = map(p);
  for (Join& join : scene.joins)
    for (Point2& p : join.line) p = map(p);
  return scene;
}

/// Returns the largest difference of heights on a grid, px of the first scene; `scale` converts.
template <class Map>
double difference(const Scene& scene, const Scene& other, Map map, double scale, Method method,
                  int vertices = 6000) {
  const Relief a = build(scene, method, vertices);
  const Relief b = build(other, method, vertices);
  double worst = 0;
  for (double y = 3.7; y < scene.height; y += 17.3)
    for (double x = 5.3; x < scene.width; x += 17.3) {
      const Probe pa = probe(a, {x, y});
      const Probe pb = probe(b, map({x, y}));
      if (!pa.found || !pb.found || pa.part != pb.part) continue;
      worst = std::max(worst, std::abs(pa.h() - pb.h() / scale));
    }
  return worst;
}

TEST_P(Invariance, ImageScale) {
  // Surfaces that join d > 0 with d < 0, as in scene 3, have several non-linear solutions.
  const int first = GetParam() == Method::nonlinear ? 4 : 3;
  for (const int seed : {first, 8, 15})
    for (const double scale : {0.5, 2.0, 10.0}) {
      const Scene scene = random_scene(seed);
      const auto map = [&](Point2 p) { return scale * p; };
      Scene other = mapped(scene, map);
      other.width *= scale;
      other.height *= scale;
      EXPECT_LT(difference(scene, other, map, scale, GetParam()), 0.01 * 100)
          << seed << " x " << scale;
    }
}

TEST_P(Invariance, Translation) {
  const Scene scene = random_scene(4);
  const auto map = [](Point2 p) { return Point2{p.x + 64, p.y + 32}; };
  EXPECT_LT(difference(scene, mapped(scene, map), map, 1, GetParam()), 1.0);
}

TEST_P(Invariance, Rotation) {
  const Scene scene = body_and_leg();
  const double a = 0.4;
  const auto map = [&](Point2 p) {
    const Point2 d = p - Point2{200, 200};
    return Point2{200 + d.x * std::cos(a) - d.y * std::sin(a),
                  200 + d.x * std::sin(a) + d.y * std::cos(a)};
  };
  EXPECT_LT(difference(scene, mapped(scene, map), map, 1, GetParam(), many_vertices), 1.0);
}

TEST_P(Invariance, LeansTurnAndGrowWithTheDrawing) {
  const double a = 0.4;
  const auto turned = [&](Point2 d) {
    return Point2{d.x * std::cos(a) - d.y * std::sin(a), d.x * std::sin(a) + d.y * std::cos(a)};
  };
  Scene scene = body_and_leg();
  scene.parts[0].lean = {0.3, -0.1};
  scene.parts[1].lean = {-0.2, 0.15};
  for (const double scale : {0.5, 2.0}) {
    const auto map = [&](Point2 p) {
      return scale * (Point2{200, 200} + turned(p - Point2{200, 200}));
    };
    Scene other = mapped(scene, map);
    other.width *= scale;
    other.height *= scale;
    for (Part& part : other.parts) part.lean = turned(part.lean);
    EXPECT_LT(difference(scene, other, map, scale, GetParam(), many_vertices), 1.0);
    other.parts[0].lean = scene.parts[0].lean;
    EXPECT_GT(difference(scene, other, map, scale, GetParam(), many_vertices), 5.0);
  }
}

TEST_P(Invariance, NamesOfLeaningParts) {
  Scene scene = body_and_leg();
  scene.parts[0].lean = {0.3, -0.1};
  Scene other = scene;
  other.parts[0].id = "leg";
  other.parts[1].id = "body";
  EXPECT_EQ(build(scene, GetParam()).ordering.h, build(other, GetParam()).ordering.h);
}

TEST_P(Invariance, OrderOfPartsThatDoNotOverlap) {
  Scene scene = body_and_leg();
  scene.parts.push_back(part("ball", circle({50, 330}, 30)));
  Scene other = scene;
  std::rotate(other.parts.begin(), other.parts.begin() + 2, other.parts.end());
  other.joins[0] = {2, 1, scene.joins[0].line};
  const Relief a = build(scene, GetParam());
  const Relief b = build(other, GetParam());
  for (const Point2 p : {Point2{200, 165}, Point2{120, 120}, Point2{200, 300}, Point2{50, 330}})
    EXPECT_NEAR(probe(a, p).h(), probe(b, p).h(), 1e-6);
}

TEST_P(Determinism, SameSceneSameBits) {
  const Scene scene = random_scene(11);
  const Relief a = build(scene, GetParam());
  const Relief b = build(scene, GetParam());
  EXPECT_EQ(a.ordering.h, b.ordering.h);
  EXPECT_EQ(a.layers.faces, b.layers.faces);
}

}  // namespace
}  // namespace relievo::relief

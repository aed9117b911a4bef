#include "lod/simplify_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "support/sample_models.h"

namespace relievo {
namespace {

using namespace testing;

using Place = std::tuple<double, double, double>;

Place place(const Model& model, int v) {
  const Point3 p = model.positions[v];
  return {p.x, p.y, p.z};
}

/// Uses of every edge by its places, in this direction.
std::map<std::pair<Place, Place>, int> edges_of(const Model& model) {
  std::map<std::pair<Place, Place>, int> edges;
  for (const std::array<int, 3>& t : model.triangles)
    for (size_t k = 0; k < 3; ++k) ++edges[{place(model, t[k]), place(model, t[(k + 1) % 3])}];
  return edges;
}

TEST(SimplifyModel, KeepsABallRoundWithFewTriangles) {
  const double radius = 40;
  const Model ball = hemisphere(radius, 64);
  const Model small = simplify_model(ball, 1000);
  ASSERT_GT(ball.triangles.size(), 10000U);
  EXPECT_LE(small.triangles.size(), 1000U);
  EXPECT_GT(small.triangles.size(), 800U);
  EXPECT_LT(small.positions.size(), 700U);
  const double middle = 0.5 * ball.width;
  for (const std::array<int, 3>& t : small.triangles) {
    Point3 sum;
    for (const int v : t) {
      const Point3 p = small.positions[v] - Point3{middle, middle, 0};
      EXPECT_NEAR(norm(p), radius, 1e-9);
      EXPECT_NEAR(dot(small.normals[v], normalized(p)), 1, p.z > 1 ? 1e-6 : 1);
      EXPECT_NEAR(small.uvs[v].x, small.positions[v].x / ball.width, 1e-9);
      sum = sum + (1.0 / 3) * p;
    }
    EXPECT_NEAR(norm(sum), radius, 0.02 * radius);
    const Point3 a = small.positions[t[0]];
    EXPECT_GT(dot(cross(small.positions[t[1]] - a, small.positions[t[2]] - a), sum), 0);
  }
  // Its rim is still a closed ring of one turn.
  double around = 0;
  const auto edges = edges_of(small);
  for (const auto& [edge, uses] : edges) {
    ASSERT_EQ(uses, 1);
    if (edges.count({edge.second, edge.first}) > 0) continue;
    const auto& [x, y, z] = edge.first;
    const auto& [u, v, w] = edge.second;
    EXPECT_EQ(z, 0);
    EXPECT_EQ(w, 0);
    around += std::hypot(u - x, v - y);
  }
  EXPECT_NEAR(around, 2 * M_PI * radius, 0.01 * around);
}

TEST(SimplifyModel, KeepsPartsAndTheirSeamClosed) {
  const Model whole = split_hemisphere(10);
  const int wanted = static_cast<int>(whole.triangles.size()) * 2 / 3;
  const Model small = simplify_model(whole, wanted);
  EXPECT_LE(small.triangles.size(), static_cast<size_t>(wanted));
  ASSERT_EQ(small.parts.size(), 2U);
  int first = 0;
  for (size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(small.parts[p].id, whole.parts[p].id);
    EXPECT_EQ(small.parts[p].first_triangle, first);
    EXPECT_GT(small.parts[p].triangle_count, wanted / 4);
    first += small.parts[p].triangle_count;
  }
  EXPECT_EQ(first, static_cast<int>(small.triangles.size()));
  const auto edges = edges_of(small);
  for (const auto& [edge, uses] : edges) {
    ASSERT_EQ(uses, 1);
    // What is open is the rim: the seam is closed.
    if (edges.count({edge.second, edge.first}) == 0) {
      EXPECT_EQ(std::get<2>(edge.first), 0);
      EXPECT_EQ(std::get<2>(edge.second), 0);
    }
  }
}

TEST(SimplifyModel, LeavesAloneWhatIsSmallEnough) {
  const Model ball = hemisphere(10, 8);
  const Model same = simplify_model(ball, static_cast<int>(ball.triangles.size()));
  EXPECT_EQ(same.triangles, ball.triangles);
  EXPECT_EQ(same.positions, ball.positions);
}

TEST(UniteParts, MakesOneOfAll) {
  const Model whole = split_hemisphere(10);
  const Model one = unite_parts(whole, "ball");
  ASSERT_EQ(one.parts.size(), 1U);
  EXPECT_EQ(one.parts[0].triangle_count, static_cast<int>(whole.triangles.size()));
  EXPECT_EQ(one.parts[0].id, "ball");
  EXPECT_EQ(one.triangles, whole.triangles);
}

TEST(SimplifyModel, InkBecomesSimplerWithItsModel) {
  Model model = hemisphere(40, 32);
  model.ink = {model.positions, model.uvs, model.triangles};
  const Model small = simplify_model(model, 1000);
  EXPECT_LE(small.all_triangles(), 1000U);
  EXPECT_GT(small.ink.triangles.size(), 400U);
  EXPECT_LT(small.ink.positions.size(), 400U);
  for (const std::array<int, 3>& t : small.ink.triangles)
    for (const int v : t) {
      const Point3 p = small.ink.positions[v] - Point3{50, 50, 0};
      EXPECT_NEAR(norm(p), 40, 1e-9);
      EXPECT_NEAR(small.ink.uvs[v].x, small.ink.positions[v].x / model.width, 1e-9);
    }
  EXPECT_EQ(unite_parts(model, "one").ink.triangles, model.ink.triangles);
}

}  // namespace
}  // namespace relievo

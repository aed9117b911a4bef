#include "kernel/meshing/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace relievo {
namespace {

constexpr double side = 100;

/// Makes the corners of a square and points in it.
std::vector<Point2> points_in_square(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return side * static_cast<double>(1 + random() % 9998) / 10000; };
  std::vector<Point2> points = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  while (static_cast<int>(points.size()) < count + 4) {
    const Point2 p{coordinate(), coordinate()};
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  }
  return points;
}

double area(const std::vector<Point2>& points, const std::array<int, 3>& t) {
  return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) / 2;
}

/// Returns a positive value where d lies inside the circumcircle of the positively oriented
/// triangle abc.
double in_circle(Point2 a, Point2 b, Point2 c, Point2 d) {
  const Point2 u = a - d, v = b - d, w = c - d;
  return dot(u, u) * cross(v, w) - dot(v, v) * cross(u, w) + dot(w, w) * cross(u, v);
}

using Edge = std::array<int, 2>;

Edge sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

class Triangulate : public ::testing::TestWithParam<unsigned> {};

TEST_P(Triangulate, FillsTheHullOnce) {
  const auto points = points_in_square(200, GetParam());
  const auto mesh = triangulate(points, {});
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->triangles.size(), 2 * points.size() - 2 - 4) << "Euler, four points on the hull";
  double sum = 0;
  for (const auto& t : mesh->triangles) {
    EXPECT_EQ(orientation(points[t[0]], points[t[1]], points[t[2]]), 1);
    sum += area(points, t);
  }
  EXPECT_NEAR(sum, side * side, 1e-9);
}

TEST_P(Triangulate, IsDelaunayWhereNoEdgeIsGiven) {
  const auto points = points_in_square(200, GetParam());
  const std::vector<Edge> given = {{0, 2}};
  std::vector<Point2> off_diagonal;
  for (const Point2 p : points)
    if (off_diagonal.size() < 4 || p.x != p.y) off_diagonal.push_back(p);
  const auto mesh = triangulate(off_diagonal, given);
  ASSERT_TRUE(mesh);
  for (size_t t = 0; t < mesh->triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto& mine = mesh->triangles[t];
      const int beyond = mesh->neighbours[t][k];
      const Edge edge = sorted(mine[(k + 1) % 3], mine[(k + 2) % 3]);
      if (beyond < 0 || edge == given[0]) continue;
      for (const int vertex : mesh->triangles[beyond])
        EXPECT_LE(in_circle(off_diagonal[mine[0]], off_diagonal[mine[1]], off_diagonal[mine[2]],
                            off_diagonal[vertex]),
                  1e-6);
    }
}

TEST_P(Triangulate, HasTheGivenEdgesAndNeighboursAcrossEveryOther) {
  const auto points = points_in_square(60, GetParam());
  // Edges between neighbours in x cannot cross.
  std::vector<int> order(points.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(points[a].x, points[a].y) < std::pair(points[b].x, points[b].y);
  });
  std::vector<Edge> given;
  for (size_t i = 0; i + 1 < order.size(); ++i) given.push_back({order[i], order[i + 1]});
  const auto mesh = triangulate(points, given);
  ASSERT_TRUE(mesh);
  std::set<Edge> edges;
  for (size_t t = 0; t < mesh->triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Edge edge = sorted(mesh->triangles[t][(k + 1) % 3], mesh->triangles[t][(k + 2) % 3]);
      edges.insert(edge);
      const int beyond = mesh->neighbours[t][k];
      if (beyond < 0) continue;
      const auto& back = mesh->neighbours[beyond];
      EXPECT_EQ(std::count(back.begin(), back.end(), static_cast<int>(t)), 1);
      for (const int end : edge)
        EXPECT_EQ(std::count(mesh->triangles[beyond].begin(), mesh->triangles[beyond].end(), end),
                  1);
    }
  for (const Edge& edge : given) EXPECT_EQ(edges.count(sorted(edge[0], edge[1])), 1U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Triangulate, ::testing::Range(1U, 9U));

TEST(TriangulateOnce, StopsWhereItIsCancelled) {
  std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  const auto mesh = triangulate(points_in_square(5000, 1), {}, context);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace relievo

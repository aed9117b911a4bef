#include "research/rivals/contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>

#include "kernel/base/disjoint_sets.h"

namespace relievo::research {
namespace {

/// How often each directed edge occurs.
std::map<std::pair<int, int>, int> directed_edges(const TriangleSurface& surface) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : surface.triangles)
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  return edges;
}

void expect_closed(const TriangleSurface& surface) {
  const auto edges = directed_edges(surface);
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
}

int euler_number(const TriangleSurface& surface) {
  return static_cast<int>(surface.positions.size()) -
         static_cast<int>(directed_edges(surface).size() / 2) +
         static_cast<int>(surface.triangles.size());
}

double volume(const TriangleSurface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += dot(surface.positions[a], cross(surface.positions[b], surface.positions[c])) / 6;
  return sum;
}

TriangleSurface contour_of(const std::vector<Bone>& bones, double cell = 0.2) {
  const auto surface = contour(Convolution(bones), cell, 0.01);
  EXPECT_TRUE(surface);
  return *surface;
}

TEST(Contour, OfAPointIsABallSeenFromOutside) {
  const TriangleSurface ball = contour_of({{{5, 6, 7}, {5, 6, 7}, 3, 3}});
  expect_closed(ball);
  EXPECT_EQ(euler_number(ball), 2);
  for (const Point3 p : ball.positions) EXPECT_NEAR(norm(p - Point3{5, 6, 7}), 3, 1e-3);
  EXPECT_NEAR(volume(ball), 4.0 / 3 * 3.14159265 * 27, 4);
}

TEST(Contour, IsClosedAndOnTheSurface) {
  const std::vector<Bone> bones = {{{0, 0, 0}, {40, 0, 0}, 8, 5},
                                   {{20, 0, 4}, {25, 30, 6}, 4, 3},
                                   {{25, 30, 6}, {45, 40, 0}, 3, 4}};
  const TriangleSurface surface = contour_of(bones);
  expect_closed(surface);
  EXPECT_EQ(euler_number(surface), 2);
  const Convolution convolution(bones);
  for (const Point3 p : surface.positions) EXPECT_NEAR(convolution.value(p), 1, 0.01);
}

TEST(Contour, FindsEveryPiece) {
  std::vector<Bone> bones;
  for (int i = 0; i < 4; ++i) {
    const Point3 p{40.0 * i, 3.0 * i, 0};
    bones.push_back({p, p, 1.0 + 3 * i, 1.0 + 3 * i});
  }
  const TriangleSurface surface = contour_of(bones);
  expect_closed(surface);
  EXPECT_EQ(euler_number(surface), 8);
}

TEST(Contour, HasCellsOfTheSizeAskedFor) {
  std::vector<Bone> bones;
  for (int i = 0; i < 12; ++i)
    bones.push_back({{5.0 * i, 0, 0}, {5.0 * i + 5, 0, 0}, 10 - 0.6 * i, 9.4 - 0.6 * i});
  const auto longest = [](const TriangleSurface& surface, double from, double to) {
    double most = 0;
    for (const auto& t : surface.triangles)
      for (int k = 0; k < 3; ++k) {
        const Point3 a = surface.positions[t[k]];
        if (a.x > from && a.x < to)
          most = std::max(most, norm(a - surface.positions[t[(k + 1) % 3]]));
      }
    return most;
  };
  const TriangleSurface surface = contour_of(bones, 0.3);
  EXPECT_LT(longest(surface, -20, 10), 2 * 0.3 * 10);
  EXPECT_LT(longest(surface, 55, 70), 2 * 0.3 * 4);
  EXPECT_GT(contour_of(bones, 0.15).triangles.size(), 3 * surface.triangles.size());
}

TEST(Contour, OfNothingIsEmptyAndStopsWhenCancelled) {
  EXPECT_TRUE(contour_of({}).triangles.empty());
  const std::atomic<bool> cancel = true;
  const auto stopped = contour(Convolution({{{0, 0, 0}, {0, 0, 0}, 1, 1}}), 0.2, 0.01,
                               RunContext{&cancel, {}, {}, {}});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace relievo::research

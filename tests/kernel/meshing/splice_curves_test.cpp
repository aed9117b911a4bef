#include "kernel/meshing/splice_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "kernel/meshing/triangulate.h"

namespace relievo {
namespace {

InputCurve circle(Point2 centre, double radius, int points) {
  InputCurve curve;
  for (int i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * i / points;
    curve.points.push_back(centre + radius * Point2{std::cos(t), std::sin(t)});
  }
  curve.kept.assign(points, false);
  return curve;
}

std::vector<InputCurve> random_circles(unsigned seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return 20 + 0.01 * static_cast<double>(random() % 6000); };
  std::vector<InputCurve> curves;
  for (int k = 0; k < 5; ++k) {
    const double radius = 5 + static_cast<double>(random() % 20);
    curves.push_back(circle({coordinate(), coordinate()}, radius, static_cast<int>(3 * radius)));
  }
  return curves;
}

using Segment = std::pair<int, int>;

std::set<Segment> edges_of(const SplicedCurves& spliced) {
  std::set<Segment> edges;
  for (const auto& loop : spliced.loops)
    for (size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  return edges;
}

/// Returns whether two segments share more than common ends.
bool meet_inside(const std::vector<Point2>& points, Segment s, Segment t) {
  if (s.first == t.first || s.first == t.second || s.second == t.first || s.second == t.second)
    return false;
  const auto side = [&](Segment line, int p) {
    return orientation(points[line.first], points[line.second], points[p]);
  };
  return side(s, t.first) * side(s, t.second) <= 0 && side(t, s.first) * side(t, s.second) <= 0;
}

class SpliceCurves : public ::testing::TestWithParam<unsigned> {};

TEST_P(SpliceCurves, LeavesNoCrossing) {
  const auto spliced = splice_curves(random_circles(GetParam()));
  ASSERT_TRUE(spliced) << to_string(spliced.error());
  const std::set<Segment> edges = edges_of(*spliced);
  for (const Segment& s : edges)
    for (const Segment& t : edges) EXPECT_FALSE(s < t && meet_inside(spliced->points, s, t));
}

TEST_P(SpliceCurves, MovesPointsByAFractionOfAnEdge) {
  const auto curves = random_circles(GetParam());
  const auto spliced = splice_curves(curves);
  ASSERT_TRUE(spliced);
  for (size_t k = 0; k < curves.size(); ++k) {
    ASSERT_EQ(spliced->image[k].size(), curves[k].points.size());
    const double edge = distance(curves[k].points[0], curves[k].points[1]);
    for (size_t i = 0; i < curves[k].points.size(); ++i)
      EXPECT_LE(distance(curves[k].points[i], spliced->points[spliced->image[k][i]]),
                2 * snap_to_vertex * edge);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, SpliceCurves, ::testing::Range(1U, 13U));

TEST(SpliceCurvesOnce, KeepsCurvesThatDoNotMeet) {
  const std::vector<InputCurve> curves = {circle({20, 20}, 10, 30), circle({60, 20}, 10, 30)};
  const auto spliced = splice_curves(curves);
  ASSERT_TRUE(spliced);
  for (size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(spliced->loops[k].size(), 30U);
    for (size_t i = 0; i < 30; ++i)
      EXPECT_EQ(spliced->points[spliced->image[k][i]], curves[k].points[i]);
  }
}

TEST(SpliceCurvesOnce, GivesEqualCurvesTheSamePoints) {
  const auto spliced = splice_curves({circle({20, 20}, 10, 30), circle({20, 20}, 10, 30)});
  ASSERT_TRUE(spliced);
  EXPECT_EQ(std::set<int>(spliced->loops[0].begin(), spliced->loops[0].end()),
            std::set<int>(spliced->loops[1].begin(), spliced->loops[1].end()));
}

TEST(SpliceCurvesOnce, PutsTheCrossingsOfALineOnBoth) {
  InputCurve line;
  for (int x = 0; x <= 40; x += 2) line.points.push_back({static_cast<double>(x), 20.3});
  line.kept.assign(line.points.size(), false);
  line.kept.front() = line.kept.back() = true;
  const auto spliced = splice_curves({circle({20, 20}, 10, 30)}, {line});
  ASSERT_TRUE(spliced);
  const std::set<int> on_circle(spliced->loops[0].begin(), spliced->loops[0].end());
  int shared = 0;
  for (const int point : spliced->lines[0]) shared += static_cast<int>(on_circle.count(point));
  EXPECT_EQ(shared, 2);
  EXPECT_EQ(spliced->points[spliced->lines[0].front()], line.points.front());
}

}  // namespace
}  // namespace relievo


#include "io/svg/path_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

using std::numbers::pi;

/// The end points of all segments but closes.
std::vector<Point2> ends(const std::string& data) {
  std::vector<Point2> points;
  for (const PathSegment& s : parse_path_data(data)) {
    if (s.kind != SegmentKind::close) points.push_back(s.end);
  }
  return points;
}

std::vector<Polyline> lines_of(const std::string& data, double tolerance = 1e-3) {
  return flatten(parse_path_data(data), {}, tolerance, 1000000);
}

double enclosed(const std::string& data) {
  double sum = 0;
  for (const Polyline& line : lines_of(data, 1e-3)) sum += signed_area(line.points);
  return sum;
}

using Points = std::vector<Point2>;

TEST(PathData, EveryLineCommandAbsoluteAndRelative) {
  EXPECT_EQ(ends("M1,2 L3 4 H5 V6 l1,1 h-2 v-3 z"),
            (Points{{1, 2}, {3, 4}, {5, 4}, {5, 6}, {6, 7}, {4, 7}, {4, 4}}));
}

TEST(PathData, NumbersNeedNoSeparators) {
  EXPECT_EQ(ends("M.5.5-1-2l1e1-1E-1"), (Points{{.5, .5}, {-1, -2}, {9, -2.1}}));
  EXPECT_EQ(ends("m+1+2+3+4"), (Points{{1, 2}, {4, 6}}));
}

TEST(PathData, MoveRepeatsAsLine) {
  const PathData path = parse_path_data("m1 1 2 2 3 3");
  ASSERT_EQ(path.size(), 3u);
  EXPECT_EQ(path[1].kind, SegmentKind::line);
  EXPECT_EQ(path[2].end, (Point2{6, 6}));
}

TEST(PathData, CloseReturnsToTheStartOfTheSubpath) {
  const std::vector<Polyline> lines = lines_of("M10 10h5v5zl1 1");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_FALSE(lines[1].closed);
  EXPECT_EQ(lines[1].points, (Points{{10, 10}, {11, 11}}));
}

TEST(PathData, SmoothCurvesMirrorTheLastControl) {
  const PathData cubic = parse_path_data("M0 0C0 1 2 1 3 0s3 -4 6 0");
  EXPECT_EQ(cubic[2].control1, (Point2{4, -1}));
  const PathData lone = parse_path_data("M1 1L5 5S6 7 8 9");
  EXPECT_EQ(lone[2].control1, (Point2{5, 5}));
  const PathData quadratic = parse_path_data("M0 0Q1 2 2 0T4 0t2 0");
  EXPECT_NEAR(quadratic[2].control1.y, 2.0 / 3 * -2, 1e-15);
  EXPECT_NEAR(quadratic[3].control1.y, 2.0 / 3 * 2, 1e-15);
  EXPECT_NEAR(quadratic[3].control1.x, 4 + 2.0 / 3, 1e-15);
}

TEST(PathData, QuadraticEnclosesTwoThirdsOfItsTriangleHalf) {
  EXPECT_NEAR(enclosed("M0 0Q50 90 100 0z"), -100 * 90 / 3.0, 0.1);
}

TEST(PathData, ArcsHitTheFourAnalyticSolutions) {
  // Two unit circles of radius 5 pass through (0, 0) and (6, 0): centres (3, 4) and (3, -4).
  struct Case {
    const char* flags;
    Point2 centre;
    double span;
  };
  const double narrow = 2 * std::asin(3.0 / 5);
  const Case cases[] = {{"0 0", {3, -4}, narrow},
                        {"0 1", {3, 4}, narrow},
                        {"1 0", {3, 4}, 2 * pi - narrow},
                        {"1 1", {3, -4}, 2 * pi - narrow}};
  for (const Case& c : cases) {
    const auto lines = lines_of(std::string("M0 0A5 5 0 ") + c.flags + " 6 0", 1e-5);
    ASSERT_EQ(lines.size(), 1u);
    double length = 0;
    const Points& points = lines[0].points;
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(distance(points[i], c.centre), 5, 5e-5) << c.flags;
      if (i > 0) length += distance(points[i - 1], points[i]);
    }
    EXPECT_EQ(points.back(), (Point2{6, 0}));
    EXPECT_NEAR(length, 5 * c.span, 1e-3) << c.flags;
  }
}

TEST(PathData, ArcFlagsInAllNotations) {
  const Points wanted = ends("M0 0 A 5 5 0 1 0 6 2");
  for (const char* data : {"M0 0A5 5 0 106 2", "M0 0A5 5 0 1,0,6,2", "M0 0A5 5 0 10 6 2",
                           "M0 0A5,5,0,1 06 2", "M0 0a5 5 0 106 2"}) {
    EXPECT_EQ(ends(data), wanted) << data;
  }
  EXPECT_EQ(ends("M0 0a5 5 0 01.5.5").back(), (Point2{.5, .5}));
}

TEST(PathData, RotatedArcLiesOnItsEllipse) {
  const double phi = 30 * pi / 180;
  PathData quarter = {{SegmentKind::move, {}, {}, {8 * std::cos(phi), 8 * std::sin(phi)}}};
  append_arc(quarter, quarter[0].end, {8, 3, 30, false, true},
             {-3 * std::sin(phi), 3 * std::cos(phi)});
  const auto lines = flatten(quarter, {}, 1e-5, 10000);
  EXPECT_GT(lines[0].points.size(), 20u);
  for (const Point2 p : lines[0].points) {
    const double u = (std::cos(phi) * p.x + std::sin(phi) * p.y) / 8;
    const double v = (-std::sin(phi) * p.x + std::cos(phi) * p.y) / 3;
    EXPECT_NEAR(u * u + v * v, 1, 3e-5);
  }
}

TEST(PathData, SmallRadiiGrowAndZeroRadiiAreLines) {
  const auto grown = lines_of("M0 0A1 1 0 0 1 10 0", 1e-4);
  for (const Point2 p : grown[0].points) EXPECT_NEAR(distance(p, {5, 0}), 5, 1e-3);
  const PathData line = parse_path_data("M0 0A0 5 0 0 1 10 0");
  ASSERT_EQ(line.size(), 2u);
  EXPECT_EQ(line[1].kind, SegmentKind::line);
  EXPECT_EQ(parse_path_data("M1 1A5 5 0 0 1 1 1").size(), 1u);
}

TEST(PathData, AnErrorKeepsWhatComesBefore) {
  struct Case {
    const char* data;
    size_t segments;
  };
  for (const Case& c : {Case{"M0 0L1 1L2", 2}, Case{"M0 0L1 1#L2 2", 2}, Case{"M0 0L1 1 C1 1 2", 2},
                        Case{"L1 1", 0}, Case{"M0 0A5 5 0 2 0 1 1", 1}, Case{"M0 0 L 1,,1", 1},
                        Case{"M0 0z1 1", 2}, Case{"x", 0}}) {
    bool complete = true;
    EXPECT_EQ(parse_path_data(c.data, &complete).size(), c.segments) << c.data;
    EXPECT_FALSE(complete) << c.data;
  }
  bool complete = false;
  EXPECT_TRUE(parse_path_data("", &complete).empty());
  EXPECT_TRUE(complete);
}

TEST(PathData, FlatteningKeepsItsTolerance) {
  for (const double tolerance : {1.0, 0.1, 0.01}) {
    const auto lines = flatten(parse_path_data("M100 0A100 100 0 0 1 -100 0"), {}, tolerance, 9999);
    const Points& points = lines[0].points;
    for (size_t i = 1; i < points.size(); ++i) {
      const double sagitta = 100 - norm(0.5 * (points[i - 1] + points[i]));
      EXPECT_LE(sagitta, tolerance + 2e-3);
    }
  }
}

TEST(PathData, HugeCurvesStayBounded) {
  EXPECT_LE(lines_of("M0 0C1e300 0 -1e300 9 5 5", 1e-3)[0].points.size(), 201u);
  EXPECT_LE(lines_of("M0 0C1e999 0 -1e999 9 5 5", 1e-3)[0].points.size(), 201u);
  EXPECT_LE(flatten(parse_path_data("M0 0h1h1h1h1h1h1h1h1"), {}, 1, 4)[0].points.size(), 6u);
}

}  // namespace
}  // namespace relievo

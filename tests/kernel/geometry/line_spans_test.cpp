#include <gtest/gtest.h>

#include <random>

#include "kernel/geometry/polyline.h"

namespace relievo {
namespace {

const Outline frame = {{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                       {{40, 40}, {40, 60}, {60, 60}, {60, 40}}};

double length_inside(const std::vector<Point2>& line, const Outline& outline) {
  double sum = 0;
  for (const LineSpan span : spans_inside(line, outline)) sum += span.to - span.from;
  return sum;
}

TEST(LineSpans, AHoleCutsALine) {
  const std::vector<LineSpan> spans = spans_inside({{-10, 50}, {50, 50}, {110, 50}}, frame);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_DOUBLE_EQ(spans[0].from, 10);
  EXPECT_DOUBLE_EQ(spans[0].to, 50);
  EXPECT_DOUBLE_EQ(spans[1].from, 70);
  EXPECT_DOUBLE_EQ(spans[1].to, 110);
}

TEST(LineSpans, LinesThroughVerticesAndFromTheOutlineCountOnce) {
  const Outline diamond = {{{50, 0}, {100, 50}, {50, 100}, {0, 50}}};
  EXPECT_DOUBLE_EQ(length_inside({{50, 0}, {50, 100}}, diamond), 100);
  EXPECT_DOUBLE_EQ(length_inside({{50, 100}, {50, 0}}, diamond), 100);
  EXPECT_DOUBLE_EQ(length_inside({{50, -50}, {50, 150}}, diamond), 100);
  EXPECT_DOUBLE_EQ(length_inside({{0, 50}, {50, 50}, {100, 50}}, diamond), 100);
  EXPECT_DOUBLE_EQ(length_inside({{10, 0}, {90, 0}}, diamond), 0);
}

TEST(LineSpans, NothingIsInsideWhereThereIsNothing) {
  EXPECT_TRUE(spans_inside({}, frame).empty());
  EXPECT_TRUE(spans_inside({{1, 1}}, frame).empty());
  EXPECT_TRUE(spans_inside({{1, 1}, {1, 1}}, frame).empty());
  EXPECT_TRUE(spans_inside({{1, 1}, {2, 2}}, {}).empty());
}

TEST(LineSpans, AgreeWithPointsOnRandomLines) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-30, 130);
  for (int round = 0; round < 50; ++round) {
    std::vector<Point2> line;
    for (int i = 0; i < 6; ++i) line.push_back({coordinate(random), coordinate(random)});
    constexpr int samples = 4000;
    int inside = 0;
    const double length = line_length(line);
    for (int i = 0; i < samples; ++i)
      inside += contains(frame, point_on_line(line, (i + 0.5) * length / samples)) ? 1 : 0;
    EXPECT_NEAR(length_inside(line, frame), inside * length / samples, 30 * length / samples);
  }
}

TEST(LineSpans, LinesGoOnStraightBeyondTheirEnds) {
  const std::vector<Point2> line = {{0, 0}, {10, 0}, {10, 20}};
  EXPECT_EQ(point_on_line(line, -5), (Point2{-5, 0}));
  EXPECT_EQ(point_on_line(line, 12), (Point2{10, 2}));
  EXPECT_EQ(point_on_line(line, 35), (Point2{10, 25}));
}

}  // namespace
}  // namespace relievo

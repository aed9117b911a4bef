#include <gtest/gtest.h>

#include <cmath>

#include "kernel/geometry/polygon.h"
#include "kernel/geometry/polyline.h"

namespace relievo {
namespace {

TEST(SimplifyLine, KeepsCornersAndEndsOnly) {
  std::vector<Point2> line;
  for (int k = 0; k < 10; ++k) line.push_back(Point2{k * 1.0, 0});
  for (int k = 0; k <= 10; ++k) line.push_back(Point2{10, k * 1.0});
  EXPECT_EQ(simplify_line(line, 0.01), (std::vector<Point2>{{0, 0}, {10, 0}, {10, 10}}));
}

TEST(SimplifyLine, NoPointIsFartherThanTheTolerance) {
  std::vector<Point2> line;
  for (int k = 0; k < 400; ++k) line.push_back(Point2{0.1 * k, 3 * std::sin(0.05 * k)});
  size_t before = line.size();
  for (const double tolerance : {0.01, 0.1, 1.0}) {
    const std::vector<Point2> few = simplify_line(line, tolerance);
    for (const Point2 p : line) EXPECT_LE(distance_to_polyline(few, p), tolerance);
    EXPECT_LT(few.size(), before);
    before = few.size();
  }
}

TEST(SimplifyLine, ShortLinesStay) {
  EXPECT_TRUE(simplify_line({}, 1).empty());
  EXPECT_EQ(simplify_line({{1, 2}}, 1).size(), 1U);
  EXPECT_EQ(simplify_line({{1, 2}, {1, 2}}, 1).size(), 2U);
}

}  // namespace
}  // namespace relievo

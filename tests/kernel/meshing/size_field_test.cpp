#include "kernel/meshing/size_field.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace relievo {
namespace {

const Outline square = {{{20, 20}, {80, 20}, {80, 80}, {20, 80}}};

/// Makes fine samples along the left side and the coarsest along the right.
std::vector<CurveSample> along_the_sides(double spacing, double coarsest) {
  std::vector<CurveSample> samples;
  for (double y = 10; y <= 90; y += spacing) samples.push_back({{10, y}, spacing});
  for (double y = 10; y <= 90; y += coarsest) samples.push_back({{90, y}, coarsest});
  return samples;
}

SizeField field_of(double spacing, const SizeOptions& options) {
  return make_size_field(along_the_sides(spacing, options.max_size), {square}, options);
}

TEST(SizeField, GrowsAsTheGradingSaysUpToTheBound) {
  const SizeOptions options{0.25, 8, 200};
  const SizeField field = field_of(1, options);
  for (double x = 11; x < 90; x += 3) {
    const double wanted = std::min(options.max_size, 1 + options.grading * (x - 10));
    EXPECT_NEAR(field.size_at({x, 50}), wanted, options.grading * 2 * field.cell + 0.05) << x;
  }
  EXPECT_EQ(*std::max_element(field.size.begin(), field.size.end()), options.max_size);
}

TEST(SizeField, CountsTheRegionsOverACell) {
  const Outline corner = {{{50, 50}, {80, 50}, {80, 80}, {50, 80}}};
  const SizeField field = make_size_field(along_the_sides(1, 8), {square, corner}, {0.25, 8, 200});
  EXPECT_EQ(field.cover_at({30, 30}), 1);
  EXPECT_EQ(field.cover_at({70, 70}), 2);
}

TEST(LatticePoints, LieInsideApartAsTheFieldSays) {
  const SizeField field = field_of(1, {0.25, 8, 200});
  const std::vector<Point2> points = lattice_points(field);
  ASSERT_GT(points.size(), 50U);
  size_t near = 0;
  for (const Point2 p : points) {
    EXPECT_GT(std::min({p.x - 20, 80 - p.x, p.y - 20, 80 - p.y}), -2 * field.cell);
    if (p.x < 50) ++near;
    for (const Point2 q : points) EXPECT_TRUE(p == q || distance(p, q) > 0.3 * field.size_at(p));
  }
  EXPECT_GT(near, points.size() / 2) << "the finer half has most of the points";
}

TEST(LatticePoints, AreFourTimesAsManyOfHalfTheSize) {
  const auto count = [](double size) {
    return static_cast<double>(lattice_points(field_of(size, {0, 16, 200})).size());
  };
  EXPECT_NEAR(count(2) / count(4), 4, 0.5);
  EXPECT_NEAR(count(1) / count(2), 4, 0.5);
}

}  // namespace
}  // namespace relievo

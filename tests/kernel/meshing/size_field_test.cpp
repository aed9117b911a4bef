#include "kernel/meshing/size_field.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace relievo {
namespace {

const Outline square = {{{10, 10}, {90, 10}, {90, 90}, {10, 90}}};

/// Fine samples along the left side, the coarsest along the right.
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
  const Outline corner = {{{50, 50}, {90, 50}, {90, 90}, {50, 90}}};
  const SizeField field = make_size_field(along_the_sides(1, 8), {square, corner}, {0.25, 8, 200});
  EXPECT_EQ(field.cover_at({30, 30}), 1);
  EXPECT_EQ(field.cover_at({70, 70}), 2);
}

TEST(LatticePoints, LieInsideApartAsTheFieldSays) {
  const SizeField field = field_of(1, {0.25, 8, 200});
  const std::vector<Point2> points = lattice_points(field);
  ASSERT_GT(points.size(), 100U);
  size_t near = 0;
  for (const Point2 p : points) {
    EXPECT_TRUE(contains(square, p) ||
                std::min({p.x - 10, 90 - p.x, p.y - 10, 90 - p.y}) > -2 * field.cell);
    if (p.x < 30) ++near;
    for (const Point2 q : points) EXPECT_TRUE(p == q || distance(p, q) > 0.3 * field.size_at(p));
  }
  EXPECT_GT(near, points.size() / 2) << "a quarter of the square has most of the points";
}

TEST(LatticePoints, AreTheMoreTheSmallerTheSize) {
  const size_t coarse = lattice_points(field_of(2, {0.1, 16, 200})).size();
  const size_t fine = lattice_points(field_of(1, {0.1, 8, 200})).size();
  EXPECT_GT(fine, 2 * coarse);
  EXPECT_LT(fine, 6 * coarse);
}

}  // namespace
}  // namespace relievo

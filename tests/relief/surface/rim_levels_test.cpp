#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "relief/surface/cut_faces.h"

namespace relievo::relief {
namespace {

double signed_square(double f) { return f * std::abs(f); }

/// Worst distance of sgn(u) sqrt|u| from its chord between two heights.
double chord_error(double a, double b) {
  const double u_a = signed_square(a);
  const double u_b = signed_square(b);
  double worst = 0;
  for (int i = 1; i < 1000; ++i) {
    const double t = std::pow(i / 1000.0, 3);
    for (const double s : {t, 1 - t}) {
      const double u = u_a + s * (u_b - u_a);
      const double f = u < 0 ? -std::sqrt(-u) : std::sqrt(u);
      worst = std::max(worst, std::abs(f - (a + s * (b - a))));
    }
  }
  return worst;
}

TEST(RimLevels, LevelAndHeightAreInverse) {
  const double tolerance = 0.25;
  for (const double f : {-300.0, -1.0, 0.02, 0.5, 7.0, 1000.0})
    EXPECT_NEAR(rim_height(rim_level(signed_square(f), tolerance), tolerance), f,
                1e-12 * std::abs(f));
  for (const double u : {0.0, 1e-12, -1e-12}) EXPECT_EQ(rim_level(u, tolerance), 0);
}

TEST(RimLevels, ChordsOfOneLevelStayWithinTolerance) {
  const double tolerance = 0.25;
  const auto error_from = [tolerance](double low) {
    return chord_error(rim_height(low, tolerance), rim_height(low + 1, tolerance));
  };
  for (double low = 0; low < 12; low += 0.37) EXPECT_LE(error_from(low), tolerance);
  EXPECT_GT(error_from(0), 0.9 * tolerance);
  EXPECT_GT(error_from(9), 0.9 * tolerance);
}

TEST(RimLevels, CutsSpanAtMostOneLevelAndStopAtZero) {
  const std::vector<std::array<double, 2>> ends{{0, 0.4}, {0, 6.3},  {5, 2.5},  {-3.2, 4.1},
                                                {0, -2},  {-0.1, 9}, {3, -0.2}, {1, 1}};
  for (const auto [first, last] : ends) {
    std::vector<double> chain{first};
    for (int i = 0; i < cut_count(first, last); ++i) chain.push_back(cut_level(first, last, i));
    chain.push_back(last);
    for (size_t i = 1; i < chain.size(); ++i) {
      EXPECT_LE(std::abs(chain[i] - chain[i - 1]), 1 + 1e-9);
      EXPECT_GE(chain[i] * chain[i - 1], 0) << first << " to " << last;
      if (first != last) {
        EXPECT_GT((chain[i] - chain[i - 1]) * (last - first), 0);
      }
    }
  }
  EXPECT_EQ(cut_count(0, 1), 0);
  EXPECT_EQ(cut_count(0, 1.01), 1);
  EXPECT_EQ(cut_count(1, 1), 0);
}

TEST(RimLevels, BothDirectionsGiveTheSameCuts) {
  for (const auto& [first, last] : {std::array{0.0, 6.5}, std::array{-1.5, 4.2}}) {
    const int n = cut_count(first, last);
    ASSERT_EQ(n, cut_count(last, first));
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(cut_level(first, last, i), cut_level(last, first, n - 1 - i), 1e-14);
  }
}

}  // namespace
}  // namespace relievo::relief

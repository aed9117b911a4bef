#include <gtest/gtest.h>

#include "relief/nonlinear/nonlinear_model.h"

namespace relievo::relief {
namespace {

TEST(SmoothRoot, IsInvertedByU) {
  for (const double width : {0.0, 1e-3, 0.05, 0.2}) {
    const SmoothRoot root(width);
    for (const double u : {-2.0, -1e-2, -1e-6, 1e-9, 3e-4, 0.5, 40.0})
      EXPECT_NEAR(root.u(root.f(u)), u, 1e-12 * std::abs(u)) << width;
    EXPECT_EQ(root.f(0), 0);
    EXPECT_EQ(root.u(0), 0);
  }
}

TEST(SmoothRoot, SlopeIsTheDerivativeAndBounded) {
  const double width = 0.05;
  const SmoothRoot root(width);
  double steepest = 0;
  for (double u = -0.02; u <= 0.02; u += 1e-4) {
    const double step = 1e-7;
    EXPECT_NEAR(root.slope(u), (root.f(u + step) - root.f(u - step)) / (2 * step), 1e-5);
    steepest = std::max(steepest, root.slope(u));
  }
  EXPECT_NEAR(steepest, 1 / width, 1e-6 / width);
}

TEST(SmoothRoot, IsTheRootFarFromZero) {
  const SmoothRoot sharp;
  const SmoothRoot smooth(0.05);
  EXPECT_EQ(sharp.f(-4), -2);
  EXPECT_EQ(sharp.slope(4), 0.25);
  for (const double f : {0.2, 0.4, 0.8}) {
    const double bound = std::pow(0.05 / f, 4) / 4;
    EXPECT_NEAR(smooth.f(f * f) / f, 1, 1.01 * bound);
  }
}

}  // namespace
}  // namespace relievo::relief

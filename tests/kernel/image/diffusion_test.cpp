#include "kernel/image/diffusion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relievo {
namespace {

void fix(ImageF& known, int x, int y, float value) {
  known.at(x, y, 0) = value;
  known.at(x, y, 1) = fixed_weight;
}

TEST(Diffusion, IsLinearBetweenTwoEdges) {
  ImageF known(65, 40, 2);
  for (int y = 0; y < 40; ++y) {
    fix(known, 0, y, 0);
    fix(known, 64, y, 1);
  }
  const ImageF p = diffuse(known);
  for (int x = 0; x < 65; ++x) EXPECT_NEAR(p.at(x, 20), x / 64.0, 0.04);
}

TEST(Diffusion, ObeysTheMaximumPrinciple) {
  ImageF known(80, 60, 2);
  for (int x = 10; x < 50; ++x) {
    fix(known, x, 20, 1);
    fix(known, x, 19, 0);
  }
  for (const float value : diffuse(known).pixels) {
    EXPECT_GE(value, -0.02F);
    EXPECT_LE(value, 1.02F);
  }
}

TEST(Diffusion, ClosesAGapStraight) {
  // A wall with a gap: one below it, zero above. By symmetry one half lies on the wall.
  ImageF known(120, 80, 2);
  for (int x = 0; x < 120; ++x) {
    if (x >= 50 && x < 70) continue;
    fix(known, x, 39, 0);
    fix(known, x, 40, 1);
  }
  const ImageF p = diffuse(known);
  for (int x = 50; x < 70; ++x) {
    EXPECT_LT(p.at(x, 36), 0.5F);
    EXPECT_GT(p.at(x, 43), 0.5F);
  }
}

/// A step is smoothed on both sides: with w = 1/36 the solution of u'' = w (u - v) decays by a
/// factor e every 6 px.
TEST(Diffusion, SmoothsAStepOverItsWeight) {
  ImageF known(200, 20, 2);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 200; ++x) {
      known.at(x, y, 0) = x < 100 ? -1.0F : 1.0F;
      known.at(x, y, 1) = 1.0F / 36;
    }
  const ImageF u = diffuse(known);
  for (int x = 100; x < 130; ++x)
    EXPECT_NEAR(u.at(x, 10), 1 - std::exp(-(x - 99.5) / 6), 0.02) << x;
}

/// Unknown pixels continue the known ones beside them.
TEST(Diffusion, FillsAHoleInAPlane) {
  ImageF known(128, 128, 2);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      if (std::hypot(x - 60, y - 66) < 30) continue;
      known.at(x, y, 0) = 0.01F * static_cast<float>(x);
      known.at(x, y, 1) = 1;
    }
  const ImageF u = diffuse(known);
  for (int y = 10; y < 118; ++y)
    for (int x = 10; x < 118; ++x) EXPECT_NEAR(u.at(x, y), 0.01 * x, 0.02);
}

}  // namespace
}  // namespace relievo

#include "kernel/image/illusory_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relievo {
namespace {

TEST(IllusorySurface, IsLinearBetweenTwoEdges) {
  Image<Cell> cells(65, 40, 1, Cell::open);
  for (int y = 0; y < 40; ++y) {
    cells.at(0, y) = Cell::zero;
    cells.at(64, y) = Cell::one;
  }
  const ImageF p = diffuse_contour(cells);
  for (int x = 0; x < 65; ++x) EXPECT_NEAR(p.at(x, 20), x / 64.0, 0.04);
}

TEST(IllusorySurface, ObeysTheMaximumPrinciple) {
  Image<Cell> cells(80, 60, 1, Cell::open);
  for (int x = 10; x < 50; ++x) {
    cells.at(x, 20) = Cell::one;
    cells.at(x, 19) = Cell::zero;
  }
  for (const float value : diffuse_contour(cells).pixels) {
    EXPECT_GE(value, -0.02F);
    EXPECT_LE(value, 1.02F);
  }
}

TEST(IllusorySurface, ClosesAGapStraight) {
  // A wall with a gap: one below it, zero above. By symmetry one half lies on the wall.
  Image<Cell> cells(120, 80, 1, Cell::open);
  for (int x = 0; x < 120; ++x) {
    if (x >= 50 && x < 70) continue;
    cells.at(x, 39) = Cell::zero;
    cells.at(x, 40) = Cell::one;
  }
  const ImageF p = diffuse_contour(cells);
  for (int x = 50; x < 70; ++x) {
    EXPECT_LT(p.at(x, 36), 0.5F);
    EXPECT_GT(p.at(x, 43), 0.5F);
  }
}

}  // namespace
}  // namespace relievo

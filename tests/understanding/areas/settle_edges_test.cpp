#include "understanding/areas/settle_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr int canvas = 80;

/// Computes the share of a pixel inside a disc, from its distance to the centre.
double coverage(int x, int y, double centre, double radius) {
  return std::clamp(radius + 0.5 - std::hypot(x + 0.5 - centre, y + 0.5 - centre), 0.0, 1.0);
}

TEST(SettleEdges, PixelsBelongToTheSideThatCoversMostOfThem) {
  constexpr double centre = 40.3;
  constexpr double radius = 22.7;
  for (const int shift : {-2, -1, 1, 2}) {
    Image8 rgb(canvas, canvas, 3);
    Image8 barrier(canvas, canvas, 1);
    Image<int32_t> index(canvas, canvas, 1);
    for (int y = 0; y < canvas; ++y)
      for (int x = 0; x < canvas; ++x) {
        const double inside = coverage(x, y, centre, radius);
        rgb.at(x, y, 0) = 255;
        rgb.at(x, y, 1) = rgb.at(x, y, 2) = static_cast<uint8_t>(255 - 200 * inside);
        const double beside = coverage(x + shift, y, centre, radius);
        if (beside > 0 && beside < 1) barrier.at(x, y) = LineMap::edge;
        index.at(x, y) = beside > 0.5 ? 1 : 0;
      }
    settle_edges(rgb, barrier, index);
    int wrong = 0;
    for (int y = 0; y < canvas; ++y)
      for (int x = 0; x < canvas; ++x)
        wrong += index.at(x, y) != (coverage(x, y, centre, radius) > 0.5 ? 1 : 0) ? 1 : 0;
    EXPECT_EQ(wrong, 0) << shift;
  }
}

}  // namespace
}  // namespace relievo::understanding

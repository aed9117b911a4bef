#include "kernel/geometry/triangles.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace relievo {
namespace {

/// A strip of two triangles, and a separate one.
const std::vector<Triangle> strip = {{0, 1, 2}, {2, 1, 3}, {4, 5, 6}};

TEST(Triangles, ListEveryCornerAtItsNodeOnce) {
  const NodeCorners corners = corners_at_nodes(strip, 8);
  std::vector<Corner> all;
  for (int node = 0; node < 8; ++node)
    for (const Corner corner : corners.at(node)) {
      EXPECT_EQ(strip[triangle_of(corner)][place_of(corner)], node);
      all.push_back(corner);
    }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::unique(all.begin(), all.end()), all.end());
  EXPECT_EQ(all.size(), 9U);
  EXPECT_TRUE(corners.at(7).empty());
}

TEST(Triangles, ShareTheEdgeOppositeToTwoCornersOnly) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_EQ(share_edge(strip[0], i, strip[1], j), i == 0 && j == 2) << i << j;
}

TEST(Triangles, HangTogetherByTheirSmallestNode) {
  EXPECT_EQ(connected_pieces(strip, 8), (std::vector<int>{0, 0, 0, 0, 4, 4, 4, 7}));
}

}  // namespace
}  // namespace relievo

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "render/shading.h"

namespace relievo {
namespace {

TEST(LowDiscrepancy, EveryBlockOfPixelsIsOneRun) {
  for (const uint32_t side : {2U, 4U, 16U})
    for (uint32_t block = 0; block < 5; ++block) {
      std::set<uint32_t> orders;
      for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x)
          orders.insert(block_order(block * side + x, 3 * side + y, 7));
      ASSERT_EQ(orders.size(), side * side);
      EXPECT_EQ(*orders.rbegin() - *orders.begin(), side * side - 1);
      EXPECT_EQ(*orders.begin() % (side * side), 0U);
    }
}

TEST(LowDiscrepancy, AnyRunOfPointsFillsTheSquareEvenly) {
  for (const uint32_t begin : {0U, 12345U, 4294967000U}) {
    std::array<int, 16> cells{};
    for (uint32_t i = 0; i < 1024; ++i) {
      const Point2 p = even_point(begin + i);
      ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
      ++cells[static_cast<size_t>(4 * p.x) + 4 * static_cast<size_t>(4 * p.y)];
    }
    for (const int count : cells) EXPECT_NEAR(count, 64, 7);
  }
}

}  // namespace
}  // namespace relievo

#include "kernel/image/watershed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <queue>
#include <vector>

#include "support/random_image.h"

namespace relievo {
namespace {

/// Computes the least, over all paths from a seed, of the greatest height on the path, seeds
/// excluded.
std::vector<int> pass_heights(const Image8& height, const Image<int32_t>& seeds, int32_t only) {
  std::vector<int> pass(height.pixels.size(), 1000);
  using Entry = std::pair<int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (size_t i = 0; i < seeds.pixels.size(); ++i)
    if (seeds.pixels[i] > 0 && (only == 0 || seeds.pixels[i] == only))
      open.emplace(pass[i] = 0, static_cast<int>(i));
  const int w = height.width;
  while (!open.empty()) {
    const auto [value, i] = open.top();
    open.pop();
    if (value > pass[i]) continue;
    const int x = i % w;
    const int y = i / w;
    for (const auto& [u, v] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
      if (u < 0 || v < 0 || u >= w || v >= height.height || seeds.at(u, v) != 0) continue;
      const int next = std::max<int>(value, height.at(u, v));
      if (next >= pass[v * w + u]) continue;
      open.emplace(pass[v * w + u] = next, v * w + u);
    }
  }
  return pass;
}

TEST(Watershed, EveryPixelGoesToASeedOverItsLowestPass) {
  for (uint32_t seed = 0; seed < 30; ++seed) {
    const Image8 height = random_image(31, 27, 0.9, seed);
    Image<int32_t> seeds(31, 27, 1);
    const Image8 walls = random_image(31, 27, 0.1, seed + 99);
    for (size_t i = 0; i < walls.pixels.size(); ++i)
      seeds.pixels[i] = walls.pixels[i] != 0 ? -1 : 0;
    for (int k = 1; k <= 4; ++k) seeds.at((k * 7 + static_cast<int>(seed)) % 31, k * 5) = k;
    Image<int32_t> label = seeds;
    flood_from_seeds(height, label);
    const std::vector<int> best = pass_heights(height, seeds, 0);
    for (int k = 1; k <= 4; ++k) {
      const std::vector<int> mine = pass_heights(height, seeds, k);
      for (size_t i = 0; i < best.size(); ++i)
        if (label.pixels[i] == k) {
          EXPECT_EQ(mine[i], best[i]) << seed;
        }
    }
    for (size_t i = 0; i < best.size(); ++i) {
      if (seeds.pixels[i] == 0) {
        EXPECT_EQ(label.pixels[i] == 0, best[i] == 1000);
      } else {
        EXPECT_EQ(label.pixels[i], seeds.pixels[i]);
      }
    }
  }
}

TEST(Watershed, FlatGroundIsSharedInTheMiddle) {
  Image<int32_t> label(41, 9, 1);
  for (int y = 0; y < 9; ++y) {
    label.at(0, y) = 1;
    label.at(40, y) = 2;
  }
  flood_from_seeds(Image8(41, 9, 1, 77), label);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 20; ++x) {
      EXPECT_EQ(label.at(x, y), 1);
      EXPECT_EQ(label.at(40 - x, y), 2);
    }
}

}  // namespace
}  // namespace relievo

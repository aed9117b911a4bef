#include "kernel/image/watershed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "kernel/image/distance_transform.h"
#include "support/random_image.h"

namespace relievo {
namespace {

/// Least over all paths from a seed of the highest height on the way (seeds excluded).
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

/// Walls everywhere but in two discs whose gap is `gap` px wide.
Image8 two_discs(int gap) {
  Image8 wall(140, 80, 1, 1);
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 140; ++x) {
      const bool in_disc = std::hypot(x - 40, y - 40) < 30 || std::hypot(x - 100, y - 40) < 25;
      if (in_disc || (x > 40 && x < 100 && 2 * std::abs(y - 40) < gap)) wall.at(x, y) = 0;
    }
  return wall;
}

TEST(PeakBasins, DiscsJoinedByAGapStayApart) {
  const PeakBasins basins = peak_basins(squared_distance_to(two_discs(12)));
  ASSERT_EQ(basins.peaks.size(), 3U);
  EXPECT_NEAR(basins.peaks[1], 30, 1);
  EXPECT_NEAR(basins.peaks[2], 25, 1);
  EXPECT_EQ(basins.label.at(40, 40), 1);
  EXPECT_EQ(basins.label.at(100, 40), 2);
  EXPECT_EQ(basins.label.at(5, 5), 0);
}

TEST(PeakBasins, OptionsSayWhichPeaksStand) {
  const Image<int32_t> distance = squared_distance_to(two_discs(40));
  EXPECT_EQ(peak_basins(distance, {1.5, 1}).peaks.size(), 3U);
  EXPECT_EQ(peak_basins(distance, {8, 1}).peaks.size(), 2U);
  EXPECT_EQ(peak_basins(distance, {1.5, 0.7}).peaks.size(), 2U);
}

TEST(PeakBasins, TurningTheImageTurnsTheBasins) {
  const Image8 wall = two_discs(12);
  const PeakBasins upright = peak_basins(squared_distance_to(wall));
  const PeakBasins turned_basins = peak_basins(squared_distance_to(turned(wall)));
  const Image<int32_t> expected = turned(upright.label);
  int different = 0;
  for (size_t i = 0; i < expected.pixels.size(); ++i)
    different += expected.pixels[i] != turned_basins.label.pixels[i] ? 1 : 0;
  // Only pixels at equal distance on the pass between the basins may change sides.
  EXPECT_LE(different, 30);
}

}  // namespace
}  // namespace relievo

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "kernel/image/distance_transform.h"
#include "kernel/image/watershed.h"
#include "support/random_image.h"

namespace relievo {
namespace {

/// Computes the basins of a field of distances, no two equal, by the definition: visits pixels from
/// the highest down, labels each like its highest labelled neighbour, and unites basins that meet
/// unless the lower one rises enough above the pass. Labels are the pixels of peaks.
std::vector<int> basins_by_definition(const Image<double>& distance, const BasinOptions& options) {
  const int w = distance.width;
  const std::vector<double>& d = distance.pixels;
  const auto higher_first = [&](int a, int b) { return d[a] > d[b]; };
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(d.size()); ++i)
    if (d[i] > 0) order.push_back(i);
  std::sort(order.begin(), order.end(), higher_first);
  std::vector<int> label(d.size(), -1);
  for (const int i : order) {
    std::vector<int> labelled;
    for (const auto& [dx, dy] : {std::pair{0, -1}, {-1, 0}, {1, 0}, {0, 1}}) {
      const int x = i % w + dx;
      const int y = i / w + dy;
      if (x >= 0 && y >= 0 && x < w && y < distance.height && label[y * w + x] >= 0)
        labelled.push_back(y * w + x);
    }
    std::sort(labelled.begin(), labelled.end(), higher_first);
    label[i] = labelled.empty() ? i : label[labelled[0]];
  }
  std::vector<int> basin(d.size());
  std::iota(basin.begin(), basin.end(), 0);
  const auto meet = [&](int i, int j) {
    if (d[j] < d[i]) return;
    const int a = basin[label[i]];
    const int b = basin[label[j]];
    const int lower = d[a] < d[b] ? a : b;
    if (a == b ||
        (d[lower] - d[i] >= options.min_rise && d[i] <= options.max_pass_ratio * d[lower]))
      return;
    std::replace(basin.begin(), basin.end(), lower, a + b - lower);
  };
  for (const int i : order) {
    if (i >= w) meet(i, i - w);
    if (i % w > 0) meet(i, i - 1);
    if (i % w + 1 < w) meet(i, i + 1);
    if (i / w + 1 < distance.height) meet(i, i + w);
  }
  for (int& l : label) l = l < 0 ? -1 : basin[l];
  return label;
}

/// Makes a field of distances in eighths of px, each once, and walls; `squared` is the least square
/// that rounds down to each.
void random_field(uint32_t seed, Image<double>& distance, Image<int32_t>& squared) {
  std::vector<int> eighths(distance.pixels.size());
  std::iota(eighths.begin(), eighths.end(), 64);
  std::mt19937 random(seed);
  for (size_t k = eighths.size(); k > 1; --k) std::swap(eighths[k - 1], eighths[random() % k]);
  for (size_t i = 0; i < eighths.size(); ++i) {
    const int value = eighths[i] < 64 + static_cast<int>(seed % 20) ? 0 : eighths[i];
    distance.pixels[i] = value / 8.0;
    squared.pixels[i] = (value * value + 63) / 64;
  }
}

TEST(PeakBasins, AreThoseOfTheDefinition) {
  for (uint32_t seed = 0; seed < 200; ++seed) {
    Image<double> distance(9, 7, 1);
    Image<int32_t> squared(9, 7, 1);
    random_field(seed, distance, squared);
    for (const BasinOptions& options : {BasinOptions{0.5, 1}, BasinOptions{1.5, 0.9}}) {
      const PeakBasins found = peak_basins(squared, options);
      const std::vector<int> expected = basins_by_definition(distance, options);
      std::map<int, int> number = {{-1, 0}};
      for (size_t i = 0; i < expected.size(); ++i) {
        number.emplace(expected[i], found.label.pixels[i]);
        ASSERT_EQ(found.label.pixels[i], number[expected[i]]) << seed << ": " << i;
      }
      ASSERT_EQ(found.peaks.size(), number.size());
      for (const auto& [pixel, label] : number)
        EXPECT_EQ(found.peaks[label], pixel < 0 ? 0 : distance.pixels[pixel]);
      EXPECT_TRUE(std::is_sorted(found.peaks.begin() + 1, found.peaks.end(), std::greater<>()));
    }
  }
}

/// Makes walls everywhere but in two discs, joined by a gap of `gap` px.
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

#include "kernel/base/cyclic_runs.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace relievo {
namespace {

using Runs = std::vector<std::pair<size_t, size_t>>;

Runs runs_of(const std::string& circle) {
  Runs runs;
  for_each_run(
      circle.size(), [&](size_t i, size_t j) { return circle[i] == circle[j]; },
      [&](size_t first, size_t count) { runs.emplace_back(first, count); });
  return runs;
}

TEST(CyclicRuns, AreDividedWhereNeighboursDiffer) {
  EXPECT_EQ(runs_of("aabccc"), (Runs{{0, 2}, {2, 1}, {3, 3}}));
}

TEST(CyclicRuns, GoOnBeyondTheEnd) { EXPECT_EQ(runs_of("abba"), (Runs{{1, 2}, {3, 2}})); }

TEST(CyclicRuns, OneRunIsTheWholeCircle) {
  EXPECT_EQ(runs_of("aaa"), (Runs{{0, 3}}));
  EXPECT_EQ(runs_of("a"), (Runs{{0, 1}}));
  EXPECT_TRUE(runs_of("").empty());
}

}  // namespace
}  // namespace relievo

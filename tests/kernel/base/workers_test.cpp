#include "kernel/base/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace relievo {
namespace {

class RunTasks : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override { set_worker_count(GetParam()); }
  void TearDown() override { set_worker_count(0); }
};

TEST_P(RunTasks, CallsEachOnce) {
  for (const int count : {0, 1, 2, 100}) {
    std::vector<std::atomic<int>> calls(static_cast<size_t>(count));
    run_tasks(count, [&](int i) { ++calls[i]; });
    for (const auto& called : calls) EXPECT_EQ(called, 1);
  }
}

TEST_P(RunTasks, CoversRangesWithoutGaps) {
  for (const int count : {0, 1, 5000, 100000}) {
    std::vector<std::atomic<int>> calls(static_cast<size_t>(count));
    run_ranges(count, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) ++calls[i];
    });
    for (const auto& called : calls) EXPECT_EQ(called, 1);
  }
}

TEST_P(RunTasks, PassesOnWhatATaskThrows) {
  EXPECT_THROW(run_tasks(10,
                         [](int i) {
                           if (i == 3) throw std::runtime_error("three");
                         }),
               std::runtime_error);
}

TEST_P(RunTasks, MayBeNested) {
  std::atomic<int> calls = 0;
  run_tasks(4, [&](int) { run_tasks(5, [&](int) { ++calls; }); });
  EXPECT_EQ(calls, 20);
}

INSTANTIATE_TEST_SUITE_P(Counts, RunTasks, ::testing::Values(1, 2, 7));

}  // namespace
}  // namespace relievo

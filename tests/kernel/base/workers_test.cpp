#include "kernel/base/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>
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

/// Counts the calls of a tree of tasks, each with `width` children.
int nested_calls(int depth, int width) {
  if (depth == 0) return 1;
  std::vector<int> calls(static_cast<size_t>(width), 0);
  run_tasks(width, [&](int i) { calls[i] = nested_calls(depth - 1, width); });
  return std::accumulate(calls.begin(), calls.end(), 0);
}

TEST_P(RunTasks, MayBeNestedDeeply) { EXPECT_EQ(nested_calls(6, 4), 4096); }

TEST_P(RunTasks, SeesWhatTasksOfManyShortCallsLeft) {
  std::vector<int> values(5, 0);
  for (int call = 0; call < 20000; ++call)
    run_tasks(static_cast<int>(values.size()), [&](int i) { values[i] += i; });
  EXPECT_EQ(values, (std::vector<int>{0, 20000, 40000, 60000, 80000}));
}

TEST_P(RunTasks, FinishesWhatHasBegunWhenATaskFails) {
  for (int call = 0; call < 200; ++call) {
    std::atomic<int> begun = 0;
    std::atomic<int> ended = 0;
    EXPECT_THROW(run_tasks(100,
                           [&](int i) {
                             ++begun;
                             std::this_thread::yield();
                             if (i == 50) throw std::runtime_error("fifty");
                             ++ended;
                           }),
                 std::runtime_error);
    EXPECT_EQ(begun, ended + 1);
  }
}

TEST_P(RunTasks, PassesOnWhatNestedTasksThrow) {
  std::atomic<int> caught = 0;
  run_tasks(8, [&](int outer) {
    try {
      run_tasks(8, [&](int inner) {
        if (inner == outer) throw outer;
      });
    } catch (int thrown) {
      if (thrown == outer) ++caught;
    }
  });
  EXPECT_EQ(caught, 8);
}

TEST_P(RunTasks, ServesSeveralThreadsAtOnce) {
  std::vector<int> calls(3, 0);
  std::vector<std::thread> callers;
  for (int& own : calls)
    callers.emplace_back([&own] {
      for (int call = 0; call < 50; ++call) own += nested_calls(2, 3);
    });
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(calls, (std::vector<int>{450, 450, 450}));
}

TEST_P(RunTasks, TakesNoMoreThreadsThanItMay) {
  std::atomic<int> running = 0;
  std::atomic<int> most = 0;
  run_tasks(50, [&](int) {
    run_tasks(3, [&](int) {
      const int now = ++running;
      for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) continue;
      std::this_thread::yield();
      --running;
    });
  });
  EXPECT_LE(most, GetParam());
}

/// Two tasks that wait for each other end only if each has a thread.
TEST_P(RunTasks, RunsTasksSideBySide) {
  if (GetParam() == 1) GTEST_SKIP();
  const auto meet = [] {
    std::atomic<int> arrived = 0;
    run_tasks(2, [&](int) {
      ++arrived;
      while (arrived < 2) std::this_thread::yield();
    });
    return arrived.load();
  };
  EXPECT_EQ(meet(), 2);
  std::atomic<int> arrived = 0;
  run_tasks(2, [&](int i) {
    if (i == 1) arrived = meet();
  });
  EXPECT_EQ(arrived, 2);
}

TEST_P(RunTasks, FollowsChangesOfTheCount) {
  for (int count = 1; count < 9; ++count)
    for (const int workers : {count, GetParam()}) {
      set_worker_count(workers);
      EXPECT_EQ(nested_calls(3, 5), 125);
    }
}

INSTANTIATE_TEST_SUITE_P(Counts, RunTasks, ::testing::Values(1, 2, 7));

}  // namespace
}  // namespace relievo

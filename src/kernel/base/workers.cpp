#include "kernel/base/workers.h"

#include <algorithm>
#include <atomic>
#include <cstdint>

#if !defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__)
#define RELIEVO_THREADS
#include <exception>
#include <thread>
#include <vector>
#endif

namespace relievo {
namespace {

/// Starting a thread costs as much as this many steps of a simple loop, or more.
constexpr int shortest_range = 4096;
constexpr int ranges_per_worker = 4;

std::atomic<int> chosen_count{0};

#ifdef RELIEVO_THREADS
void run_on_threads(int helpers, int count, const std::function<void(int)>& task) {
  std::atomic<int> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  const auto take_tasks = [&] {
    try {
      for (int i = next.fetch_add(1); i < count; i = next.fetch_add(1)) task(i);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < helpers; ++i) threads.emplace_back(take_tasks);
  take_tasks();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}
#endif

}  // namespace

int worker_count() {
#ifdef RELIEVO_THREADS
  const int chosen = chosen_count.load(std::memory_order_relaxed);
  static const int available = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return chosen > 0 ? chosen : available;
#else
  return 1;
#endif
}

void set_worker_count(int count) { chosen_count.store(count, std::memory_order_relaxed); }

void run_tasks(int count, const std::function<void(int)>& task) {
#ifdef RELIEVO_THREADS
  const int helpers = std::min(worker_count(), count) - 1;
#else
  const int helpers = 0;
#endif
  if (helpers <= 0) {
    for (int i = 0; i < count; ++i) task(i);
    return;
  }
#ifdef RELIEVO_THREADS
  run_on_threads(helpers, count, task);
#endif
}

void run_ranges(int count, const std::function<void(int, int)>& work) {
  const int ranges = std::clamp(count / shortest_range, 1, ranges_per_worker * worker_count());
  run_tasks(ranges, [&](int i) {
    const auto at = [&](int r) { return static_cast<int>(int64_t{count} * r / ranges); };
    work(at(i), at(i + 1));
  });
}

}  // namespace relievo

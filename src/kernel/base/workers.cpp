#include "kernel/base/workers.h"

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "kernel/base/thread_pool.h"

namespace relievo {
namespace {

/// Waking a thread costs at least as much as this many steps of a simple loop.
constexpr int shortest_range = 4096;
constexpr int ranges_per_worker = 4;

std::atomic<int> chosen_count{0};

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
  static ThreadPool pool;
  if (count > 1 && worker_count() > 1) return pool.run(count, task, worker_count());
#endif
  for (int i = 0; i < count; ++i) task(i);
}

void run_ranges(int count, const std::function<void(int, int)>& work) {
  const int ranges = std::clamp(count / shortest_range, 1, ranges_per_worker * worker_count());
  run_tasks(ranges, [&](int i) {
    const auto at = [&](int r) { return static_cast<int>(int64_t{count} * r / ranges); };
    work(at(i), at(i + 1));
  });
}

}  // namespace relievo

#include "kernel/base/workers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#if !defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__)
#define RELIEVO_THREADS
#endif

namespace relievo {
namespace {

/// Waking a thread costs at least as much as this many steps of a simple loop.
constexpr int shortest_range = 4096;
constexpr int ranges_per_worker = 4;

std::atomic<int> chosen_count{0};

#ifdef RELIEVO_THREADS

/// Time for which an idle thread spins before it sleeps.
constexpr std::chrono::microseconds patience{100};

/// The state of one call of ThreadPool::run().
struct Batch {
  const int count;
  const std::function<void(int)>& task;
  const int workers;
  const Batch* const parent;  ///< the batch whose task called run(), or null
  int helpers = 0;            ///< threads at work besides the caller's; guarded by the mutex
  std::atomic<int> next = 0;
  std::atomic<bool> failed = false;
  std::exception_ptr failure = {};

  /// The batch whose task this thread runs, or null.
  inline static thread_local const Batch* current = nullptr;

  bool has_tasks() const { return next.load(std::memory_order_relaxed) < count; }

  bool is_within(const Batch& other) const {
    const Batch* batch = this;
    while (batch != nullptr && batch != &other) batch = batch->parent;
    return batch != nullptr;
  }

  void take_tasks() {
    const Batch* const outer = current;
    current = this;
    try {
      for (int i = next.fetch_add(1); i < count; i = next.fetch_add(1)) task(i);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
      next = count;
    }
    current = outer;
  }
};

/// A pool of threads that share the tasks of their callers. Threads start when first needed. An
/// idle thread spins for a short while before it sleeps: waking it takes longer than many tasks do.
class ThreadPool {
 public:
  ThreadPool() = default;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool() {
    {
      const Lock lock(mutex_);
      stopping_ = true;
      ++changes_;
    }
    opened_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  /// Calls task(0) .. task(count - 1), as run_tasks does, on up to `workers` threads including the
  /// caller's. The caller never waits for a thread that has not begun a task. Tasks may call run()
  /// themselves: a thread that waits for its batch helps with the nested ones.
  void run(int count, const std::function<void(int)>& task, int workers) {
    Batch batch{count, task, workers, Batch::current};
    open(batch);
    batch.take_tasks();
    close(batch);
    if (batch.failure) std::rethrow_exception(batch.failure);
  }

 private:
  using Lock = std::unique_lock<std::mutex>;
  using Clock = std::chrono::steady_clock;

  /// Offers the batch to the threads of the pool.
  void open(Batch& batch) {
    const int helpers = std::min(batch.workers, batch.count) - 1;
    {
      const Lock lock(mutex_);
      start_threads(std::min(busy_ + helpers, batch.workers - 1));
      batches_.push_back(&batch);
      ++changes_;
    }
    for (int i = 0; i < helpers; ++i) opened_.notify_one();
    changed_.notify_all();
  }

  /// Returns when nobody takes part any more.
  void close(Batch& batch) {
    Lock lock(mutex_);
    batches_.erase(std::find(batches_.begin(), batches_.end(), &batch));
    const Clock::time_point asleep = Clock::now() + patience;
    while (batch.helpers > 0)
      if (Batch* part = find([&](const Batch& other) { return other.is_within(batch); }))
        take_part(*part, lock);
      else
        await_news(asleep, changed_, lock);
  }

  /// Starts threads until there are `count`. Where the system refuses more, the existing ones do
  /// the work.
  void start_threads(int count) try {
    while (static_cast<int>(threads_.size()) < count) threads_.emplace_back([this] { help(); });
  } catch (const std::system_error&) {
  }

  /// Runs tasks of open batches until the pool stops: the loop of each thread.
  void help() {
    Lock lock(mutex_);
    Clock::time_point asleep = Clock::now() + patience;
    while (!stopping_) {
      Batch* batch = find([&](const Batch& other) { return busy_ < other.workers - 1; });
      if (batch == nullptr) {
        await_news(asleep, opened_, lock);
        continue;
      }
      ++busy_;
      take_part(*batch, lock);
      --busy_;
      asleep = Clock::now() + patience;
    }
  }

  /// Returns the oldest batch that has tasks left and suits, or null.
  Batch* find(const std::function<bool(const Batch&)>& suits) const {
    const auto found = std::find_if(batches_.begin(), batches_.end(), [&](const Batch* batch) {
      return batch->has_tasks() && suits(*batch);
    });
    return found == batches_.end() ? nullptr : *found;
  }

  void take_part(Batch& batch, Lock& lock) {
    ++batch.helpers;
    lock.unlock();
    batch.take_tasks();
    lock.lock();
    --batch.helpers;
    ++changes_;
    changed_.notify_all();
  }

  /// Waits until something changes: spins until the time `asleep`, then sleeps.
  void await_news(Clock::time_point asleep, std::condition_variable& news, Lock& lock) {
    const unsigned seen = changes_;
    lock.unlock();
    while (changes_ == seen && Clock::now() < asleep) std::this_thread::yield();
    lock.lock();
    news.wait(lock, [&] { return changes_ != seen; });
  }

  std::mutex mutex_;
  std::vector<Batch*> batches_;  ///< open ones, oldest first
  std::vector<std::thread> threads_;
  int busy_ = 0;  ///< number of threads with a task
  bool stopping_ = false;
  std::atomic<unsigned> changes_ = 0;  ///< counts the changes of the state above
  std::condition_variable opened_;     ///< wakes threads of the pool
  std::condition_variable changed_;    ///< wakes callers
};

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

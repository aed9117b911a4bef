#include "kernel/base/thread_pool.h"

#ifdef RELIEVO_THREADS

#include <algorithm>
#include <exception>
#include <system_error>

namespace relievo {
namespace {

/// How long an idle thread spins before it sleeps.
constexpr std::chrono::microseconds patience{100};

}  // namespace

/// The state of one call of run().
struct ThreadPool::Batch {
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

ThreadPool::~ThreadPool() {
  {
    const Lock lock(mutex_);
    stopping_ = true;
    ++changes_;
  }
  opened_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(int count, const std::function<void(int)>& task, int workers) {
  Batch batch{count, task, workers, Batch::current};
  open(batch);
  batch.take_tasks();
  close(batch);
  if (batch.failure) std::rethrow_exception(batch.failure);
}

/// Offers the batch to the threads of the pool.
void ThreadPool::open(Batch& batch) {
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
void ThreadPool::close(Batch& batch) {
  Lock lock(mutex_);
  batches_.erase(std::find(batches_.begin(), batches_.end(), &batch));
  const Clock::time_point asleep = Clock::now() + patience;
  while (batch.helpers > 0)
    if (Batch* part = find([&](const Batch& other) { return other.is_within(batch); }))
      take_part(*part, lock);
    else
      await_news(asleep, changed_, lock);
}

/// Starts threads until there are `count`. Where the system refuses more, the existing ones do the
/// work.
void ThreadPool::start_threads(int count) try {
  while (static_cast<int>(threads_.size()) < count) threads_.emplace_back([this] { help(); });
} catch (const std::system_error&) {
}

/// Runs tasks of open batches until the pool stops: the loop of each thread.
void ThreadPool::help() {
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
ThreadPool::Batch* ThreadPool::find(const std::function<bool(const Batch&)>& suits) const {
  const auto found = std::find_if(batches_.begin(), batches_.end(), [&](const Batch* batch) {
    return batch->has_tasks() && suits(*batch);
  });
  return found == batches_.end() ? nullptr : *found;
}

void ThreadPool::take_part(Batch& batch, Lock& lock) {
  ++batch.helpers;
  lock.unlock();
  batch.take_tasks();
  lock.lock();
  --batch.helpers;
  ++changes_;
  changed_.notify_all();
}

/// Waits until something changes: spins until the time `asleep`, then sleeps.
void ThreadPool::await_news(Clock::time_point asleep, std::condition_variable& news, Lock& lock) {
  const unsigned seen = changes_;
  lock.unlock();
  while (changes_ == seen && Clock::now() < asleep) std::this_thread::yield();
  lock.lock();
  news.wait(lock, [&] { return changes_ != seen; });
}

}  // namespace relievo

#endif

#pragma once

#if !defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__)
#define RELIEVO_THREADS

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace relievo {

/// Threads that take part in the work of others. They start when first needed and sleep when there
/// is nothing to do, but only after a short while: to wake one takes longer than many tasks do.
class ThreadPool {
 public:
  ThreadPool() = default;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool();

  /// Calls task(0) .. task(count - 1) as run_tasks does on up to `workers` threads, 1 of them the
  /// caller's, which never waits for a thread that has not begun. Tasks may call this again: a
  /// thread that waits for others takes part in what these have called.
  void run(int count, const std::function<void(int)>& task, int workers);

 private:
  struct Batch;
  using Lock = std::unique_lock<std::mutex>;
  using Clock = std::chrono::steady_clock;

  void open(Batch& batch);
  void close(Batch& batch);
  void start_threads(int count);
  void help();
  Batch* find(const std::function<bool(const Batch&)>& suits) const;
  void take_part(Batch& batch, Lock& lock);
  void await_news(Clock::time_point asleep, std::condition_variable& news, Lock& lock);

  std::mutex mutex_;
  std::vector<Batch*> batches_;  ///< open ones, oldest first
  std::vector<std::thread> threads_;
  int busy_ = 0;  ///< of the threads
  bool stopping_ = false;
  std::atomic<unsigned> changes_ = 0;  ///< of all this
  std::condition_variable opened_;     ///< for threads of the pool
  std::condition_variable changed_;    ///< for callers
};

}  // namespace relievo

#endif

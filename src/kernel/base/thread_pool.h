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

/// A pool of threads that share the tasks of their callers. Threads start when first needed. An
/// idle thread spins for a short while before it sleeps: waking it takes longer than many tasks do.
class ThreadPool {
 public:
  ThreadPool() = default;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool();

  /// Calls task(0) .. task(count - 1), as run_tasks does, on up to `workers` threads including the
  /// caller's. The caller never waits for a thread that has not begun a task. Tasks may call run()
  /// themselves: a thread that waits for its batch helps with the nested ones.
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
  int busy_ = 0;  ///< number of threads with a task
  bool stopping_ = false;
  std::atomic<unsigned> changes_ = 0;  ///< counts the changes of the state above
  std::condition_variable opened_;     ///< wakes threads of the pool
  std::condition_variable changed_;    ///< wakes callers
};

}  // namespace relievo

#endif

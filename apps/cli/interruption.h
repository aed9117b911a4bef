#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "relievo/run_context.h"

namespace relievo::cli {

/// Stops the program when it is asked to (SIGINT, SIGTERM) or its time is up. The work is first
/// asked to stop by a flag; where it does not within 60 ms (a library is busy), the process ends
/// itself. One object at a time, in the main thread.
class Interruption {
 public:
  /// `timeout` in seconds; 0: no limit.
  explicit Interruption(double timeout);
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  const std::atomic<bool>* flag() const;

  /// While the lock is held the process does not end itself: files are being written.
  std::unique_lock<std::mutex> hold_off();

  /// Nothing is left to be stopped: from here on the process ends in its own way.
  void finish();

  /// Why the work was stopped: `interrupted`, or `limit` where its time was up.
  Error reason() const;

 private:
  void watch(double timeout);
  bool wait(int milliseconds);

  std::mutex writing_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool finished_ = false;
  double timeout_ = 0;
  std::thread watcher_;
};

}  // namespace relievo::cli

#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "relievo/run_context.h"

namespace relievo::cli {

/// Stops the program on SIGINT, SIGTERM or a timeout. First sets a flag that the work checks; if
/// the work does not stop within 60 ms (a library is busy), ends the process. Only one object may
/// exist at a time, in the main thread.
class Interruption {
 public:
  /// `timeout` is in seconds; 0 means no limit.
  explicit Interruption(double timeout);
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  const std::atomic<bool>* flag() const;

  /// Keeps the process from ending while the lock is held, since files are being written.
  std::unique_lock<std::mutex> hold_off();

  /// Declares the work done: from now on nothing is interrupted.
  void finish();

  /// Returns the reason for stopping: `interrupted`, or `limit` after the timeout.
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

#pragma once

#include <chrono>

#include "relievo/run_context.h"

namespace relievo {

/// Measures wall time in milliseconds.
class Stopwatch {
 public:
  /// Returns the time since the last lap, or since construction.
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - last_).count();
  }

  /// Returns the same time, and begins a new lap.
  double lap() {
    const double elapsed = milliseconds();
    last_ = Clock::now();
    return elapsed;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

/// Reports the wall time of a piece of work, from construction to stop() or destruction, to
/// `context.timed`. `context` and `piece` outlive the timer.
class PieceTimer {
 public:
  PieceTimer(const RunContext& context, const char* piece) : context_(context), piece_(piece) {}
  PieceTimer(const PieceTimer&) = delete;
  PieceTimer& operator=(const PieceTimer&) = delete;
  ~PieceTimer() { stop(); }

  void stop() {
    if (piece_ != nullptr && context_.timed) context_.timed(piece_, watch_.milliseconds());
    piece_ = nullptr;
  }

 private:
  const RunContext& context_;
  const char* piece_;
  Stopwatch watch_;
};

}  // namespace relievo

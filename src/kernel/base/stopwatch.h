#pragma once

#include <chrono>

#include "relievo/run_context.h"

namespace relievo {

/// Measures wall time.
class Stopwatch {
 public:
  /// Since the last lap, or since construction.
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - last_).count();
  }

  /// The same, and begins a new lap.
  double lap() {
    const double elapsed = milliseconds();
    last_ = Clock::now();
    return elapsed;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

/// Tells a context how long a piece of work took: from construction to stop() or destruction.
class PieceTimer {
 public:
  PieceTimer(const RunContext& context, const char* piece) : context_(context), piece_(piece) {}
  PieceTimer(const PieceTimer&) = delete;
  PieceTimer& operator=(const PieceTimer&) = delete;
  ~PieceTimer() { stop(); }

  void stop() {
    if (piece_ == nullptr) return;
    const std::chrono::duration<double, std::milli> elapsed = Clock::now() - begin_;
    if (context_.timed) context_.timed(piece_, elapsed.count());
    piece_ = nullptr;
  }

 private:
  using Clock = std::chrono::steady_clock;

  const RunContext& context_;
  const char* piece_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace relievo

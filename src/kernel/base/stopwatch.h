#pragma once

#include <chrono>

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

}  // namespace relievo

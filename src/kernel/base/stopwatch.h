#pragma once

#include <chrono>

namespace relievo {

/// Measures wall time.
class Stopwatch {
 public:
  /// Milliseconds since the last lap, or since construction.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> elapsed = now - last_;
    last_ = now;
    return elapsed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace relievo

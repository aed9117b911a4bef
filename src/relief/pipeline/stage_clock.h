#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "kernel/base/run_context.h"

namespace relievo {

/// Wall time of a stage, or of a piece of work inside one. They do not overlap; a name may occur
/// several times.
struct StageTime {
  std::string stage;  ///< "mesh", "assemble", "analyse", "inflate", "order" or "nonlinear"
  double milliseconds = 0;
};

/// Fills a list of wall times. The time of a stage is without the pieces that it reported.
class StageClock {
 public:
  explicit StageClock(std::vector<StageTime>& times) : times_(times) {}

  /// `context` with the pieces' times going to the list.
  RunContext listen(RunContext context) {
    context.timed = [this](const char* piece, double milliseconds) {
      times_.push_back({piece, milliseconds});
      pieces_ += milliseconds;
    };
    return context;
  }

  void finish(const char* stage) {
    const auto now = Clock::now();
    const std::chrono::duration<double, std::milli> elapsed = now - last_;
    times_.push_back({stage, elapsed.count() - pieces_});
    last_ = now;
    pieces_ = 0;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<StageTime>& times_;
  Clock::time_point last_ = Clock::now();
  double pieces_ = 0;
};

}  // namespace relievo

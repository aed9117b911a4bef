#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "relievo/run_context.h"

namespace relievo {

/// Wall time of a stage, or of a piece of work inside one. A name may occur several times. Only
/// what is done beside others overlaps them.
struct StageTime {
  std::string stage;  ///< "mesh", "assemble", "analyse", "inflate", "order", "nonlinear" or "hide"
  double milliseconds = 0;
  bool beside = false;  ///< on another thread than the stage that it counts to
};

/// Fills a list of wall times. The time of a stage is without the pieces that it reported.
class StageClock {
 public:
  explicit StageClock(std::vector<StageTime>& times) : times_(times) {}

  /// `context` with the pieces' times going to the list.
  RunContext listen(RunContext context) {
    context.timed = [this](const char* piece, double milliseconds) {
      times_.push_back({piece, milliseconds, false});
      pieces_ += milliseconds;
    };
    return context;
  }

  /// The same for work on another thread; take_beside() adds its pieces when it has ended.
  RunContext listen_beside(RunContext context) {
    context.progress = {};
    context.timed = [this](const char* piece, double milliseconds) {
      beside_.push_back({piece, milliseconds, true});
    };
    return context;
  }

  void take_beside() {
    times_.insert(times_.end(), beside_.begin(), beside_.end());
    beside_.clear();
  }

  void finish(const char* stage) {
    const auto now = Clock::now();
    const std::chrono::duration<double, std::milli> elapsed = now - last_;
    times_.push_back({stage, elapsed.count() - pieces_, false});
    last_ = now;
    pieces_ = 0;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<StageTime>& times_;
  std::vector<StageTime> beside_;
  Clock::time_point last_ = Clock::now();
  double pieces_ = 0;
};

}  // namespace relievo

#pragma once

#include <atomic>
#include <functional>

#include "relievo/result.h"

namespace relievo {

/// Watches and stops a long computation. Copyable; all members are optional.
struct RunContext {
  /// Set to true, from another thread or a signal handler, to stop; checked often enough that work
  /// ends within 0.1 s. Not owned.
  const std::atomic<bool>* cancel = nullptr;
  /// Called with the name of a stage and the fraction of it that is done, in [0, 1].
  std::function<void(const char* stage, double fraction)> progress{};
  /// Called after a step of a stage ("assemble", "analyse") with its wall time.
  std::function<void(const char* piece, double milliseconds)> timed{};
  /// Called with a quantity that shows the progress of a stage ("energy").
  std::function<void(const char* quantity, double value)> measured{};

  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
  void report(const char* stage, double fraction) const {
    if (progress) progress(stage, fraction);
  }
  void measure(const char* quantity, double value) const {
    if (measured) measured(quantity, value);
  }
};

inline Error interrupted_error() { return {ErrorCode::interrupted, "interrupted", ""}; }

}  // namespace relievo

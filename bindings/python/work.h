#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>

#include "bindings/python/errors.h"
#include "relievo/run_context.h"

namespace relievo::python {

/// Waits, without the interpreter's lock, until `done_within` returns true. It blocks for at most
/// the given time. If a signal handler raises an exception (Ctrl-C), sets `cancel`, waits for the
/// end of the work, and throws that exception.
void wait_for_work(const std::function<bool(std::chrono::milliseconds)>& done_within,
                   std::atomic<bool>& cancel);

/// Calls `work` with a RunContext in a thread of its own, so that others may use the interpreter.
/// Returns its result, or raises its error.
template <class Work>
auto run(const Work& work) {
  std::atomic<bool> cancel{false};
  auto result = std::async(std::launch::async, [&] { return work(RunContext{&cancel}); });
  wait_for_work([&](auto time) { return result.wait_for(time) == std::future_status::ready; },
                cancel);
  return unwrap(result.get());
}

}  // namespace relievo::python

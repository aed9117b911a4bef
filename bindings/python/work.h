#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>

#include "bindings/python/errors.h"
#include "relievo/run_context.h"

namespace relievo::python {

/// Waits without the interpreter's lock until `done_within` is true, which it tells after at most
/// the given time. Where a signal's handler raises meanwhile (Ctrl-C), sets `cancel`, waits on, and
/// throws what was raised.
void wait_for_work(const std::function<bool(std::chrono::milliseconds)>& done_within,
                   std::atomic<bool>& cancel);

/// What `work`, a function of a RunContext, gives, computed by a thread of its own while others may
/// use the interpreter. Raises its error.
template <class Work>
auto run(const Work& work) {
  std::atomic<bool> cancel{false};
  auto result = std::async(std::launch::async, [&] { return work(RunContext{&cancel}); });
  wait_for_work([&](auto time) { return result.wait_for(time) == std::future_status::ready; },
                cancel);
  return taken(result.get());
}

}  // namespace relievo::python

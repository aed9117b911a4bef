#include "bindings/python/work.h"

#include <optional>

namespace relievo::python {
namespace {

/// What the handlers of signals that have come raise; only the main thread runs them.
std::optional<pybind11::error_already_set> raised_by_signals() {
  const pybind11::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() == 0) return std::nullopt;
  return std::optional<pybind11::error_already_set>(std::in_place);
}

}  // namespace

void wait_for_work(const std::function<bool(std::chrono::milliseconds)>& done_within,
                   std::atomic<bool>& cancel) {
  std::optional<pybind11::error_already_set> raised;
  {
    const pybind11::gil_scoped_release unlocked;
    while (!done_within(std::chrono::milliseconds(50))) {
      if (raised) continue;
      raised = raised_by_signals();
      if (raised) cancel = true;
    }
  }
  if (raised) throw pybind11::error_already_set(*raised);
}

}  // namespace relievo::python

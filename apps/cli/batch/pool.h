#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "apps/cli/batch/child.h"
#include "relievo/result.h"

namespace relievo::cli {

/// A run of the program that is still to be made.
struct PoolTask {
  std::vector<std::string> arguments;
  double expected_mb = 0;  ///< of memory
};

struct PoolOptions {
  int processes = 1;     ///< at once, at most
  double memory_mb = 0;  ///< for all of them
  std::function<bool()> stopped;
};

/// Runs the tasks in their order, as many at once as there are processes and memory for, one at
/// least, and hands over what became of each as soon as it has ended. What a task is expected to
/// take is corrected by the most that one took before; none can take more than all of the memory.
/// Errors: that of `done`, after which nothing more is begun; `interrupted`; `limit` as
/// Child::start.
Status run_pool(const std::vector<PoolTask>& tasks, const PoolOptions& options,
                const std::function<Status(size_t task, ChildOutcome outcome)>& done);

}  // namespace relievo::cli

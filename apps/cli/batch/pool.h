#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "relievo/result.h"

namespace relievo::cli {

/// The end of a run of the program.
struct TaskOutcome {
  int code = 0;          ///< exit code, or 128 + the signal that ended it
  std::string messages;  ///< its standard error
  double seconds = 0;    ///< elapsed
  double cpu_seconds = 0;
  double peak_mb = 0;  ///< memory, 2^20 bytes
};

/// A run of the program.
struct PoolTask {
  std::vector<std::string> arguments;
  double expected_mb = 0;  ///< memory
};

struct PoolOptions {
  int processes = 1;     ///< maximum number at once
  double memory_mb = 0;  ///< for all of them
  const std::atomic<bool>& stop;
};

/// Runs the tasks in order, as many at once as `options` allow, but at least one. Calls `done` with
/// the outcome of each task once it has ended. Reserves, for each task, its expected memory or the
/// most that a task has used, and limits each to the whole memory. Errors: that of `done`, after
/// which no task is started; `interrupted`; `limit` if the system can start no process.
Status run_pool(const std::vector<PoolTask>& tasks, const PoolOptions& options,
                const std::function<Status(size_t task, TaskOutcome outcome)>& done);

}  // namespace relievo::cli

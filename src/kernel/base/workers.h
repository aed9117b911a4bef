#pragma once

#include <functional>

namespace relievo {

/// Threads that long computations use: as many as the machine has, 1 where the platform has none.
/// Results do not depend on it.
int worker_count();

/// Sets it for the whole process, at least 1; 0: as many as the machine has. Not while anything is
/// computed.
void set_worker_count(int count);

/// Calls task(0) .. task(count - 1), each once, on up to worker_count() threads, the caller's among
/// them, and returns when all are done. Tasks begin in ascending order. What the first of them to
/// fail throws is thrown again, and tasks that have not begun are left out.
void run_tasks(int count, const std::function<void(int)>& task);

/// Cuts [0, count) into a few runs of about the same length and calls work(begin, end) for each
/// like run_tasks. Short ranges, where threads do not pay, are one run.
void run_ranges(int count, const std::function<void(int, int)>& work);

}  // namespace relievo

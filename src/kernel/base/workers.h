#pragma once

#include <functional>

namespace relievo {

/// Returns the number of threads that long computations use: as many as the machine has, 1 where
/// the platform has none. Results do not depend on it.
int worker_count();

/// Sets that number for the whole process; 0 stands for as many as the machine has. Precondition:
/// count >= 0, and nothing is being computed.
void set_worker_count(int count);

/// Calls task(0) .. task(count - 1), each once, on up to worker_count() threads including the
/// caller's, and returns when all are done. Tasks begin in ascending order. Where a task throws,
/// rethrows the first exception; tasks that have not begun by then are skipped.
void run_tasks(int count, const std::function<void(int)>& task);

/// Divides [0, count) into a few ranges of about equal length and calls work(begin, end) for each,
/// as run_tasks does. Short ranges, for which threads do not pay, are not divided.
void run_ranges(int count, const std::function<void(int, int)>& work);

}  // namespace relievo

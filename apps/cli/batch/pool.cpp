#include "apps/cli/batch/pool.h"

#include <poll.h>

#include <algorithm>

#include "relievo/run_context.h"

namespace relievo::cli {
namespace {

/// Interval at which the pool checks whether to stop, ms.
constexpr int poll_interval = 50;

struct Running {
  size_t task;
  double reserved_mb;
  Child child;
};

class Pool {
 public:
  Pool(const std::vector<PoolTask>& tasks, const PoolOptions& options)
      : tasks_(tasks), options_(options) {}

  /// Starts tasks while there is room.
  Status start_some() {
    while (next_ < tasks_.size() && has_room()) {
      auto child = Child::start(tasks_[next_].arguments,
                                static_cast<uint64_t>(options_.memory_mb * (1 << 20)));
      if (!child && running_.empty()) return child.error();
      if (!child) return Done{};
      reserved_mb_ += needed_mb();
      running_.push_back({next_, needed_mb(), std::move(*child)});
      ++next_;
    }
    return Done{};
  }

  bool idle() const { return running_.empty(); }

  /// Waits for a moment. Returns the tasks that have ended.
  std::vector<std::pair<size_t, ChildOutcome>> wait_for_some() {
    std::vector<pollfd> streams;
    for (const Running& one : running_) streams.push_back({one.child.stream(), POLLIN, 0});
    std::vector<std::pair<size_t, ChildOutcome>> ended;
    if (poll(streams.data(), streams.size(), poll_interval) <= 0) return ended;
    for (size_t k = running_.size(); k-- > 0;) {
      if (streams[k].revents == 0 || !running_[k].child.take()) continue;
      ended.emplace_back(running_[k].task, running_[k].child.wait());
      most_mb_ = std::max(most_mb_, ended.back().second.peak_mb);
      reserved_mb_ -= running_[k].reserved_mb;
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return ended;
  }

 private:
  double needed_mb() const { return std::max(tasks_[next_].expected_mb, most_mb_); }

  bool has_room() const {
    if (running_.empty()) return true;
    return static_cast<int>(running_.size()) < options_.processes &&
           reserved_mb_ + needed_mb() <= options_.memory_mb;
  }

  const std::vector<PoolTask>& tasks_;
  const PoolOptions& options_;
  std::vector<Running> running_;
  size_t next_ = 0;
  double reserved_mb_ = 0;
  double most_mb_ = 0;  ///< used by a task so far
};

}  // namespace

Status run_pool(const std::vector<PoolTask>& tasks, const PoolOptions& options,
                const std::function<Status(size_t task, ChildOutcome outcome)>& done) {
  Pool pool(tasks, options);
  while (true) {
    if (options.stopped()) return interrupted_error();
    if (Status status = pool.start_some(); !status) return status;
    if (pool.idle()) return Done{};
    for (auto& [task, outcome] : pool.wait_for_some())
      if (Status status = done(task, std::move(outcome)); !status) return status;
  }
}

}  // namespace relievo::cli

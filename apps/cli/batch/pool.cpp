#include "apps/cli/batch/pool.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <memory>
#include <utility>

#include "kernel/base/stopwatch.h"
#include "relievo/run_context.h"

namespace relievo::cli {
namespace {

/// Interval at which the pool checks whether to stop, ms.
constexpr int poll_interval = 50;

/// Maximum length of the messages of a child, bytes. More than a build writes; the rest is lost.
constexpr size_t most_messages = 64 << 10;

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Address space is not limited under sanitizers, which use terabytes.
#ifdef __SANITIZE_ADDRESS__
constexpr bool bounds_memory = false;
#else
constexpr bool bounds_memory = true;
#endif

/// Replaces the forked process by the program. Calls nothing that another thread may have locked.
[[noreturn]] void become(char* const* argv, int errors, rlim_t memory, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);
  const struct rlimit limit = {memory, memory};
  if (bounds_memory) setrlimit(RLIMIT_AS, &limit);
  const int nothing = open("/dev/null", O_RDWR);
  if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0 || dup2(nothing, STDOUT_FILENO) < 0 ||
      dup2(errors, STDERR_FILENO) < 0)
    _exit(127);
  execv("/proc/self/exe", argv);
  _exit(127);
}

/// A child process that runs this program with other arguments. It receives SIGTERM when this
/// process ends, for any reason.
class Child {
 public:
  /// Starts a child, whose address space is limited to `memory` bytes. Returns nothing if the
  /// system cannot start another process.
  static std::unique_ptr<Child> start(const std::vector<std::string>& arguments, uint64_t memory);

  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  /// A file descriptor that is readable once the child has written something or ended.
  int stream() const { return stream_; }

  /// Reads its messages. Returns whether it has ended.
  bool take();

  /// Returns its outcome. Precondition: take() has returned true.
  TaskOutcome wait();

 private:
  explicit Child(int stream) : stream_(stream) {}

  pid_t id_ = -1;
  int stream_;
  std::string messages_;
  Stopwatch watch_;
};

Child::~Child() {
  close(stream_);
  if (id_ <= 0) return;
  kill(id_, SIGTERM);
  waitpid(id_, nullptr, 0);
}

std::unique_ptr<Child> Child::start(const std::vector<std::string>& arguments, uint64_t memory) {
  std::vector<char*> argv = {const_cast<char*>("relievo")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC) != 0) return nullptr;
  std::unique_ptr<Child> child(new Child(pipe[0]));
  const pid_t parent = getpid();
  child->id_ = fork();
  if (child->id_ == 0) become(argv.data(), pipe[1], memory, parent);
  close(pipe[1]);
  if (child->id_ < 0) return nullptr;
  return child;
}

bool Child::take() {
  std::array<char, 4096> buffer{};
  const ssize_t count = read(stream_, buffer.data(), buffer.size());
  if (count < 0) return errno != EINTR && errno != EAGAIN;
  if (messages_.size() < most_messages) messages_.append(buffer.data(), count);
  return count == 0;
}

TaskOutcome Child::wait() {
  int status = 0;
  struct rusage usage = {};
  const pid_t id = std::exchange(id_, -1);
  while (wait4(id, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, std::move(messages_), watch_.milliseconds() / 1000,
          seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

struct Running {
  size_t task;
  double reserved_mb;
  std::unique_ptr<Child> child;
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
      if (!child && running_.empty())
        return Error{ErrorCode::limit, "cannot start another process; use fewer --jobs", ""};
      if (!child) return Done{};
      reserved_mb_ += needed_mb();
      running_.push_back({next_, needed_mb(), std::move(child)});
      ++next_;
    }
    return Done{};
  }

  bool idle() const { return running_.empty(); }

  /// Waits for a moment. Returns the tasks that have ended.
  std::vector<std::pair<size_t, TaskOutcome>> wait_for_some() {
    std::vector<pollfd> streams;
    for (const Running& one : running_) streams.push_back({one.child->stream(), POLLIN, 0});
    std::vector<std::pair<size_t, TaskOutcome>> ended;
    if (poll(streams.data(), streams.size(), poll_interval) <= 0) return ended;
    for (size_t k = running_.size(); k-- > 0;) {
      if (streams[k].revents == 0 || !running_[k].child->take()) continue;
      ended.emplace_back(running_[k].task, running_[k].child->wait());
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
                const std::function<Status(size_t task, TaskOutcome outcome)>& done) {
  Pool pool(tasks, options);
  while (true) {
    if (options.stop) return interrupted_error();
    if (Status status = pool.start_some(); !status) return status;
    if (pool.idle()) return Done{};
    for (auto& [task, outcome] : pool.wait_for_some())
      if (Status status = done(task, std::move(outcome)); !status) return status;
  }
}

}  // namespace relievo::cli

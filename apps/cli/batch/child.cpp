#include "apps/cli/batch/child.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <utility>

namespace relievo::cli {
namespace {

/// Maximum length of its messages, bytes. More than a build writes; the rest is lost.
constexpr size_t most_messages = 64 << 10;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

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

}  // namespace

Child::Child(Child&& other) noexcept
    : id_(std::exchange(other.id_, -1)),
      stream_(std::exchange(other.stream_, -1)),
      messages_(std::move(other.messages_)),
      started_(other.started_) {}

Child& Child::operator=(Child&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(stream_, other.stream_);
  std::swap(messages_, other.messages_);
  std::swap(started_, other.started_);
  return *this;
}

Child::~Child() {
  if (stream_ >= 0) close(stream_);
  if (id_ <= 0) return;
  stop();
  waitpid(id_, nullptr, 0);
}

Result<Child> Child::start(const std::vector<std::string>& arguments, uint64_t memory) {
  std::vector<char*> argv = {const_cast<char*>("relievo")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const Error refused{ErrorCode::limit, "cannot start another process; use fewer --jobs", ""};
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC) != 0) return refused;
  Child child;
  child.stream_ = pipe[0];
  child.started_ = now();
  const pid_t parent = getpid();
  child.id_ = fork();
  if (child.id_ == 0) become(argv.data(), pipe[1], memory, parent);
  close(pipe[1]);
  if (child.id_ < 0) return refused;
  return child;
}

bool Child::take() {
  std::array<char, 4096> buffer{};
  const ssize_t count = read(stream_, buffer.data(), buffer.size());
  if (count < 0) return errno != EINTR && errno != EAGAIN;
  if (messages_.size() < most_messages) messages_.append(buffer.data(), count);
  return count == 0;
}

ChildOutcome Child::wait() {
  int status = 0;
  struct rusage usage = {};
  const pid_t id = std::exchange(id_, -1);
  while (wait4(id, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, std::move(messages_), now() - started_,
          seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

void Child::stop() const { kill(id_, SIGTERM); }

}  // namespace relievo::cli

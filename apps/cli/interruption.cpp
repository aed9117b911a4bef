#include "apps/cli/interruption.h"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>

#include "apps/cli/exit_code.h"
#include "apps/cli/messages.h"

namespace relievo::cli {
namespace {

// A signal handler may only use lock-free globals.
std::atomic<bool> stop{false};
std::atomic<bool> time_is_up{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_signal(int) { stop.store(true, std::memory_order_relaxed); }

void handle(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption(double timeout) : timeout_(timeout) {
  stop = false;
  time_is_up = false;
  handle(SIGINT, on_signal);
  handle(SIGTERM, on_signal);
  watcher_ = std::thread([this, timeout] { watch(timeout); });
}

Interruption::~Interruption() {
  finish();
  watcher_.join();
  handle(SIGINT, SIG_IGN);
  handle(SIGTERM, SIG_IGN);
}

void Interruption::finish() {
  const std::lock_guard lock(mutex_);
  finished_ = true;
  wake_.notify_one();
}

const std::atomic<bool>* Interruption::flag() const { return &stop; }

std::unique_lock<std::mutex> Interruption::hold_off() { return std::unique_lock(writing_); }

Error Interruption::reason() const {
  if (!time_is_up) return interrupted_error();
  std::string seconds = std::to_string(timeout_);
  seconds.erase(seconds.find_last_not_of('0') + 1);
  if (seconds.back() == '.') seconds.pop_back();
  return {ErrorCode::limit, "did not finish within --timeout " + seconds + " s", ""};
}

/// Sleeps. Returns false if the work has finished meanwhile.
bool Interruption::wait(int milliseconds) {
  std::unique_lock lock(mutex_);
  return !wake_.wait_for(lock, std::chrono::milliseconds(milliseconds),
                         [this] { return finished_; });
}

void Interruption::watch(double timeout) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  while (!stop) {
    if (!wait(10)) return;
    if (timeout <= 0 || std::chrono::duration<double>(Clock::now() - begin).count() < timeout)
      continue;
    time_is_up = true;
    stop = true;
  }
  if (!wait(60)) return;
  const std::lock_guard lock(writing_);
  if (!wait(0)) return;
  print_error(reason());
  _exit(exit_code(reason().code));
}

}  // namespace relievo::cli

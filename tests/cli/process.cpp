#include "cli/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace relievo {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void redirect(const fs::path& path, int flags, int stream) {
  const int file = open(path.c_str(), flags, 0600);
  if (file < 0 || dup2(file, stream) < 0) _exit(127);
}

}  // namespace

Process::Process(const fs::path& folder, const std::vector<std::string>& arguments,
                 const std::string& input, const fs::path& out) {
  std::string streams = testing::TempDir() + "relievo_streams_XXXXXX";
  streams_ = mkdtemp(streams.data());
  std::ofstream(streams_ / "in", std::ios::binary) << input;
  std::vector<char*> argv = {const_cast<char*>(RELIEVO_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  id_ = fork();
  if (id_ != 0) return;
  redirect(streams_ / "in", O_RDONLY, STDIN_FILENO);
  redirect(out.empty() ? streams_ / "out" : out, O_WRONLY | O_CREAT, STDOUT_FILENO);
  redirect(streams_ / "err", O_WRONLY | O_CREAT, STDERR_FILENO);
  if (chdir(folder.c_str()) != 0) _exit(127);
  execv(RELIEVO_PROGRAM, argv.data());
  _exit(127);
}

Process::~Process() {
  if (id_ > 0) {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  fs::remove_all(streams_);
}

void Process::send(int signal) const { kill(id_, signal); }

void Process::wait_until_handled(int signal) const {
  // The kernel lists the signals that a process handles as bits of a hexadecimal number.
  const std::string status = "/proc/" + std::to_string(id_) + "/status";
  const std::string key = "SigCgt:";
  for (std::ifstream file(status); file; file = std::ifstream(status)) {
    for (std::string line; std::getline(file, line);) {
      if (line.rfind("State:\tZ", 0) == 0) return;
      if (line.rfind(key, 0) != 0) continue;
      if ((std::stoull(line.substr(key.size()), nullptr, 16) >> (signal - 1) & 1) != 0) return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

Outcome Process::wait() {
  int status = 0;
  waitpid(id_, &status, 0);
  id_ = -1;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, content_of(streams_ / "out"), content_of(streams_ / "err")};
}

Outcome run(const fs::path& folder, const std::vector<std::string>& arguments,
            const std::string& input) {
  return Process(folder, arguments, input).wait();
}

Outcome run_into(const fs::path& out, const fs::path& folder,
                 const std::vector<std::string>& arguments) {
  return Process(folder, arguments, "", out).wait();
}

}  // namespace relievo

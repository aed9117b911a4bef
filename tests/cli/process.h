#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace relievo {

/// The end of a run of the program.
struct Outcome {
  int exit_code = -1;  ///< 128 + the signal where one killed it
  std::string out;     ///< what it wrote on standard output
  std::string err;     ///< and on standard error
};

/// A run of the program in a folder, its streams going to files elsewhere.
class Process {
 public:
  /// Starts the program with `arguments`; standard input is `input`, standard output goes to the
  /// file `out` where that is not empty.
  Process(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
          const std::string& input = "", const std::filesystem::path& out = {});
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  void send(int signal) const;

  /// Waits until the program handles a signal itself, or has ended.
  void wait_until_handled(int signal) const;

  /// Waits for the end.
  Outcome wait();

 private:
  pid_t id_ = -1;
  std::filesystem::path streams_;  ///< folder of the redirected streams
};

/// Runs the program to its end.
Outcome run(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
            const std::string& input = "");

/// The same with standard output going to the file `out`.
Outcome run_into(const std::filesystem::path& out, const std::filesystem::path& folder,
                 const std::vector<std::string>& arguments);

}  // namespace relievo

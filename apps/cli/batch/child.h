#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "relievo/result.h"

namespace relievo::cli {

/// How a child ended.
struct ChildOutcome {
  int code = 0;          ///< exit code; 128 + the signal where one ended it
  std::string messages;  ///< what it wrote on standard error
  double seconds = 0;    ///< by the clock
  double cpu_seconds = 0;
  double peak_mb = 0;
};

/// This program, run once more with other arguments. It is asked to stop when this process ends,
/// however that comes.
class Child {
 public:
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  ~Child();

  /// `memory`: bytes of address space that it may take. Errors: `limit` where the system has no
  /// more processes.
  static Result<Child> start(const std::vector<std::string>& arguments, uint64_t memory);

  /// Readable when it has written something, or ended.
  int stream() const { return stream_; }

  /// Takes what it has written; whether it has ended since.
  bool take();

  /// Waits for its end, which take() has seen.
  ChildOutcome wait();

  /// Asks it to stop.
  void stop() const;

 private:
  Child() = default;

  pid_t id_ = -1;
  int stream_ = -1;
  std::string messages_;
  double started_ = 0;
};

}  // namespace relievo::cli

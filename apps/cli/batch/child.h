#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "relievo/result.h"

namespace relievo::cli {

/// The end of a child process.
struct ChildOutcome {
  int code = 0;          ///< exit code, or 128 + the signal that ended it
  std::string messages;  ///< its standard error
  double seconds = 0;    ///< elapsed
  double cpu_seconds = 0;
  double peak_mb = 0;  ///< memory, 2^20 bytes
};

/// A child process that runs this program with other arguments. It receives SIGTERM when this
/// process ends, for any reason.
class Child {
 public:
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  ~Child();

  /// Starts a child. `memory` limits its address space, bytes. Errors: `limit` if the system cannot
  /// start another process.
  static Result<Child> start(const std::vector<std::string>& arguments, uint64_t memory);

  /// A file descriptor that is readable once the child has written something or ended.
  int stream() const { return stream_; }

  /// Reads its messages. Returns whether it has ended.
  bool take();

  /// Returns its outcome. Precondition: take() has returned true.
  ChildOutcome wait();

  /// Sends it SIGTERM.
  void stop() const;

 private:
  Child() = default;

  pid_t id_ = -1;
  int stream_ = -1;
  std::string messages_;
  double started_ = 0;
};

}  // namespace relievo::cli

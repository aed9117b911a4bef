#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::cli {

/// Replaces control characters, so that names from a file cannot control the terminal.
std::string printable(const std::string& text);

/// The beginning of every line on stderr, and the word that follows in warnings.
constexpr std::string_view program_prefix = "relievo: ";
constexpr std::string_view warning_prefix = "warning: ";

/// Prints one line on stderr: "relievo: where: message".
void print_error(const Error& error);

/// Print lines on stderr, unless `quiet`.
void print_warnings(const std::vector<std::string>& warnings, bool quiet);
void print_note(const std::string& text, bool quiet);

/// Prints a line on standard output, unless `quiet`.
void print_result(const std::string& text, bool quiet);

/// Flushes standard output. Errors: `file` if it cannot be written.
Status flush_results();

/// A progress line on stderr, rewritten in place and removed by the destructor. Shows nothing if
/// `quiet` or if stderr is not a terminal.
class Progress {
 public:
  explicit Progress(bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Shows the progress reported to `context`, which must not outlive this object.
  void watch(RunContext& context);

 private:
  bool shown_;
  std::chrono::steady_clock::time_point last_;
  std::string measured_;
};

}  // namespace relievo::cli

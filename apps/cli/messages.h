#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::cli {

/// `text` with control characters replaced, so that names from a file cannot steer the terminal.
std::string printable(const std::string& text);

/// What a line on stderr begins with, and after it a warning.
constexpr std::string_view program_prefix = "relievo: ";
constexpr std::string_view warning_prefix = "warning: ";

/// One line on stderr: "relievo: where: message".
void print_error(const Error& error);

/// Lines on stderr, none when `quiet`.
void print_warnings(const std::vector<std::string>& warnings, bool quiet);
void print_note(const std::string& text, bool quiet);

/// A line on standard output, none when `quiet`.
void print_result(const std::string& text, bool quiet);

/// Whether all results have been taken.
Status flush_results();

/// One line of progress on stderr, rewritten in place; only when stderr is a terminal and not
/// `quiet`. Leaves no trace once it is gone.
class Progress {
 public:
  explicit Progress(bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Shows what happens under the context, for as long as this lives.
  void watch(RunContext& context);

 private:
  bool shown_;
  std::chrono::steady_clock::time_point last_;
  std::string measured_;
};

}  // namespace relievo::cli

#pragma once

#include <atomic>
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

/// Sets whether errors alone are printed: --quiet.
void set_quiet(bool quiet);

/// Print lines on stderr, unless quiet.
void print_warnings(const std::vector<std::string>& warnings);
void print_note(const std::string& text);

/// Prints a line on standard output, unless quiet.
void print_result(const std::string& text);

/// Flushes standard output. Errors: `file` if it cannot be written.
Status flush_results();

/// Show and remove a line on stderr that is rewritten in place, unless quiet or stderr is not a
/// terminal.
void show_progress(const std::string& line);
void clear_progress();

/// Shows the progress of work in such a line, until it is destroyed.
class Progress {
 public:
  Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear_progress(); }

  /// Returns a context that reports to this object, which must outlive it.
  RunContext context(const std::atomic<bool>* cancel);

 private:
  std::chrono::steady_clock::time_point last_;
  std::string measured_;
};

}  // namespace relievo::cli

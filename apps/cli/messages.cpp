#include "apps/cli/messages.h"

#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>

namespace relievo::cli {
namespace {

void print_line(std::string_view kind, const std::string& text) {
  const std::string line = std::string(program_prefix).append(kind) + printable(text) + "\n";
  std::fputs(line.c_str(), stderr);
}

}  // namespace

std::string printable(const std::string& text) {
  std::string safe = text;
  for (char& c : safe)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return safe;
}

void print_error(const Error& error) { print_line("", to_string(error)); }

void print_warnings(const std::vector<std::string>& warnings, bool quiet) {
  if (quiet) return;
  for (const std::string& warning : warnings) print_line(warning_prefix, warning);
}

void print_note(const std::string& text, bool quiet) {
  if (!quiet) print_line("", text);
}

void print_result(const std::string& text, bool quiet) {
  if (!quiet) std::printf("%s%s", text.c_str(), text.empty() || text.back() != '\n' ? "\n" : "");
}

Status flush_results() {
  if (std::fflush(stdout) == 0) return Done{};
  return Error{ErrorCode::file, "cannot write to standard output", ""};
}

Progress::Progress(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::watch(RunContext& context) {
  if (!shown_) return;
  context.progress = [this](const char* stage, double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return;
    last_ = now;
    std::fprintf(stderr, "\r\033[K%s %3.0f %%%s", stage, 100 * fraction, measured_.c_str());
    std::fflush(stderr);
  };
  context.measured = [this](const char* quantity, double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), ", %s %.6g", quantity, value);
    measured_ = text.data();
  };
}

}  // namespace relievo::cli

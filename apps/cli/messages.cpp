#include "apps/cli/messages.h"

#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>

namespace relievo::cli {
namespace {

bool is_quiet = false;

bool shows_progress() { return !is_quiet && isatty(STDERR_FILENO) != 0; }

void print_line(std::string_view kind, const std::string& text) {
  const std::string line = std::string(program_prefix).append(kind) + printable(text) + "\n";
  std::fflush(stdout);  // The two streams may lead to one place, where lines keep their order.
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

void set_quiet(bool quiet) { is_quiet = quiet; }

void print_warnings(const std::vector<std::string>& warnings) {
  if (is_quiet) return;
  for (const std::string& warning : warnings) print_line(warning_prefix, warning);
}

void print_note(const std::string& text) {
  if (!is_quiet) print_line("", text);
}

void print_result(const std::string& text) {
  if (!is_quiet) std::printf("%s%s", text.c_str(), text.ends_with('\n') ? "" : "\n");
}

Status flush_results() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return Done{};
  return Error{ErrorCode::file, "cannot write to standard output", ""};
}

void show_progress(const std::string& line) {
  if (shows_progress()) std::fprintf(stderr, "\r\033[K%s", line.c_str());
}

void clear_progress() { show_progress(""); }

RunContext Progress::context(const std::atomic<bool>* cancel) {
  RunContext context{cancel};
  if (!shows_progress()) return context;
  context.progress = [this](const char* stage, double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return;
    last_ = now;
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%s %3.0f %%", stage, 100 * fraction);
    show_progress(text.data() + measured_);
  };
  context.measured = [this](const char* quantity, double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), ", %s %.6g", quantity, value);
    measured_ = text.data();
  };
  return context;
}

}  // namespace relievo::cli

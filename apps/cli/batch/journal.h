#pragma once

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "relievo/result.h"

namespace relievo::cli {

/// The outcome of one drawing: a line of a journal.
struct JournalEntry {
  std::string name;
  std::string input;
  std::string digest;  ///< of the input
  std::vector<std::string> options;
  std::string version;  ///< of the program
  int code = 0;         ///< exit code of its build
  std::string message;  ///< the error if it failed
  std::vector<std::string> warnings;
  double seconds = 0;      ///< elapsed
  double cpu_seconds = 0;  ///< of all its threads
  double peak_mb = 0;      ///< of memory, 2^20 bytes
  std::vector<std::string> files;
  std::string finished;  ///< date and time, UTC, ISO 8601
};

/// The last entry of each drawing, by name.
using JournalEntries = std::map<std::string, JournalEntry>;

/// Reads all journals of a folder. Ignores a line that a killed batch left half-written. Errors:
/// `file`; `bad_input` for a line that is not an entry, with its place.
Result<JournalEntries> read_journals(const std::filesystem::path& folder);

/// Returns the paths of the journals in a folder, sorted.
std::vector<std::filesystem::path> journals_in(const std::filesystem::path& folder);

/// Formats an entry as a line of JSON.
std::string journal_line(const JournalEntry& entry);

/// A journal to append to. Only one process can have it open.
class Journal {
 public:
  /// Opens a journal, or creates it. Errors: `file`, also if another process has it open.
  static Result<Journal> open(const std::filesystem::path& path);

  /// Appends an entry in one write, so that a killed process leaves whole lines.
  Status add(const JournalEntry& entry);

 private:
  Journal() = default;

  std::unique_ptr<FILE, int (*)(FILE*)> stream_{nullptr, std::fclose};
  std::filesystem::path path_;
};

}  // namespace relievo::cli

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "relievo/result.h"

namespace relievo::cli {

/// What became of one drawing: a line of a journal.
struct JournalEntry {
  std::string name;
  std::string input;
  std::string digest;  ///< of the input
  std::vector<std::string> options;
  std::string version;  ///< of the program
  int code = 0;         ///< exit code of its build
  std::string message;  ///< why it failed
  std::vector<std::string> warnings;
  double seconds = 0;      ///< by the clock
  double cpu_seconds = 0;  ///< of all its threads
  double peak_mb = 0;      ///< of memory, 2^20 bytes
  std::vector<std::string> files;
  std::string finished;  ///< time of day, UTC, as in ISO 8601
};

/// The last entry of each drawing, by name.
using JournalEntries = std::map<std::string, JournalEntry>;

/// What all journals of a folder say. A line that a killed batch left half-written counts as none.
/// Errors: `file`; `bad_input` where a line is no entry, `where` names it.
Result<JournalEntries> read_journals(const std::filesystem::path& folder);

/// The journals of a folder.
std::vector<std::filesystem::path> journals_in(const std::filesystem::path& folder);

std::string journal_line(const JournalEntry& entry);

/// A journal that entries are added to, by one process at a time.
class Journal {
 public:
  Journal() = default;
  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&& other) noexcept;
  ~Journal();

  /// Makes the file where there is none. Errors: `file`, also where another process has it.
  static Result<Journal> open(const std::filesystem::path& path);

  /// Adds a line at once, so that a process that is killed leaves whole lines.
  Status add(const JournalEntry& entry);

 private:
  int file_ = -1;
  std::filesystem::path path_;
};

}  // namespace relievo::cli

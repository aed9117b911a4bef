#include "apps/cli/batch/journal.h"

#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <sstream>

#include "relievo/files.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr uint64_t largest_journal = uint64_t{4} << 30;  ///< bytes

/// Calls visit(name, value) for each field of an entry, in the order of the line.
template <class Entry, class Visit>
void each_field(Entry& entry, Visit visit) {
  visit("name", entry.name);
  visit("input", entry.input);
  visit("digest", entry.digest);
  visit("options", entry.options);
  visit("version", entry.version);
  visit("code", entry.code);
  visit("message", entry.message);
  visit("warnings", entry.warnings);
  visit("seconds", entry.seconds);
  visit("cpu_seconds", entry.cpu_seconds);
  visit("peak_mb", entry.peak_mb);
  visit("files", entry.files);
  visit("finished", entry.finished);
}

Result<JournalEntry> read_entry(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    JournalEntry entry;
    each_field(entry, [&](const char* name, auto& value) { json.at(name).get_to(value); });
    return entry;
  } catch (const Json::exception&) {
    return Error{ErrorCode::bad_input,
                 "is not a journal entry; remove the line, and its drawing will be built again",
                 ""};
  }
}

Status read_journal(const fs::path& path, JournalEntries& entries) {
  const auto bytes = read_file(path, largest_journal);
  if (!bytes) return bytes.error();
  std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  text.erase(text.find_last_of('\n') + 1);
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty()) continue;
    auto entry = read_entry(line);
    if (!entry)
      return Error{entry.error().code, entry.error().message,
                   path.string() + ":" + std::to_string(number)};
    JournalEntry& known = entries[entry->name];
    if (known.finished <= entry->finished) known = std::move(*entry);
  }
  return Done{};
}

Error cannot_write(const fs::path& path) {
  return {ErrorCode::file, "cannot be written: " + std::generic_category().message(errno),
          path.string()};
}

}  // namespace

std::string journal_line(const JournalEntry& entry) {
  Json json;
  each_field(entry, [&](const char* name, const auto& value) { json[name] = value; });
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<fs::path> journals_in(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code code;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    const std::string name = it->path().filename().string();
    if (name.starts_with("journal") && name.ends_with(".jsonl")) paths.push_back(it->path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

Result<JournalEntries> read_journals(const fs::path& folder) {
  JournalEntries entries;
  for (const fs::path& path : journals_in(folder))
    if (Status status = read_journal(path, entries); !status) return status.error();
  return entries;
}

Result<Journal> Journal::open(const fs::path& path) {
  Journal journal;
  journal.path_ = path;
  journal.stream_.reset(std::fopen(path.c_str(), "a+e"));
  if (!journal.stream_) return cannot_write(path);
  const int file = fileno(journal.stream_.get());
  if (flock(file, LOCK_EX | LOCK_NB) != 0)
    return Error{ErrorCode::file, "another batch is writing it", path.string()};
  // Remove a line that a killed batch left half-written.
  const off_t size = lseek(file, 0, SEEK_END);
  char last = '\n';
  if (size > 0 && pread(file, &last, 1, size - 1) == 1 && last != '\n') {
    const auto bytes = read_file(path, largest_journal);
    if (!bytes) return bytes.error();
    const auto end = std::find(bytes->rbegin(), bytes->rend(), static_cast<uint8_t>('\n'));
    if (ftruncate(file, bytes->rend() - end) != 0) return cannot_write(path);
  }
  return journal;
}

Status Journal::add(const JournalEntry& entry) {
  const std::string line = journal_line(entry);
  const ssize_t written = write(fileno(stream_.get()), line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size())) return Done{};
  return cannot_write(path_);
}

}  // namespace relievo::cli

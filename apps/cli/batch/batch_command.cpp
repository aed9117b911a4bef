#include "apps/cli/batch/batch_command.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>

#include "apps/cli/batch/passed_over.h"
#include "apps/cli/batch/plan.h"
#include "apps/cli/batch/pool.h"
#include "apps/cli/batch/sheet_page.h"
#include "apps/cli/cost.h"
#include "apps/cli/exit_code.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "io/files/number_text.h"
#include "kernel/base/stopwatch.h"
#include "relievo/files.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

/// Share of the free memory that is used by default.
constexpr double share_of_memory = 0.8;

int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

/// Extracts the warnings of a build, and the error if it failed.
void read_messages(const std::string& text, JournalEntry& entry) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool ours = line.starts_with(program_prefix);
    if (ours) line.erase(0, program_prefix.size());
    if (ours && line.starts_with(warning_prefix))
      entry.warnings.push_back(line.substr(warning_prefix.size()));
    else if (entry.code != 0)
      entry.message = line;
  }
  if (entry.code > 128 && entry.message.empty())
    entry.message =
        "internal error (please report it): ended by signal " + std::to_string(entry.code - 128);
}

/// A progress line on a terminal, rewritten in place.
class Rate {
 public:
  Rate(size_t all, bool quiet) : all_(all), shown_(!quiet && isatty(STDERR_FILENO) != 0) {}

  void count(bool failed) {
    ++done_;
    failed_ += failed ? 1 : 0;
    if (!shown_) return;
    const double rate = static_cast<double>(done_) / std::max(seconds(), 1e-3);
    const auto left = std::lround(std::ceil(static_cast<double>(all_ - done_) / rate));
    std::fprintf(stderr, "\r\033[K%zu of %zu, %zu failed, %.1f a second, %ld:%02ld:%02ld left",
                 done_, all_, failed_, rate, left / 3600, left / 60 % 60, left % 60);
    std::fflush(stderr);
  }

  void clear() const {
    if (shown_) std::fputs("\r\033[K", stderr);
  }

  double seconds() const { return watch_.milliseconds() / 1000; }

 private:
  Stopwatch watch_;
  size_t all_;
  size_t done_ = 0;
  size_t failed_ = 0;
  bool shown_;
};

std::vector<PoolTask> tasks_of(const BatchPlan& plan, int processes) {
  const std::string threads = std::to_string(std::max(1, processors() / processes));
  std::vector<PoolTask> tasks;
  for (const auto& [entry, vertices] : plan.builds) {
    std::vector<std::string> words = {"build", entry.input, "--threads", threads};
    words.insert(words.end(), entry.options.begin(), entry.options.end());
    tasks.push_back({std::move(words), least_mb(vertices)});
  }
  return tasks;
}

/// Completes the entry of a finished build. Errors: `interrupted` if the batch is being stopped.
Result<JournalEntry> finished(JournalEntry entry, const ChildOutcome& outcome) {
  if (outcome.code == exit_interrupted || outcome.code == 128 + SIGTERM) return interrupted_error();
  entry.code = outcome.code;
  read_messages(outcome.messages, entry);
  entry.seconds = outcome.seconds;
  entry.cpu_seconds = outcome.cpu_seconds;
  entry.peak_mb = outcome.peak_mb;
  entry.finished = time_of_day();
  if (entry.code != 0) entry.files.clear();
  return entry;
}

/// Builds the drawings of a plan. Returns the time that it took, s.
Result<double> build_planned(const BatchArguments& batch, const BatchPlan& plan, Journal& journal,
                             JournalEntries& entries, Interruption& interruption) {
  for (const BatchJob& job : plan.builds)
    for (const fs::path file : job.entry.files)
      if (Status status = make_folder(file.parent_path()); !status) return status.error();
  const int processes = batch.jobs > 0 ? batch.jobs : processors();
  const double memory = batch.memory_mb > 0 ? batch.memory_mb : share_of_memory * free_mb();
  Rate rate(plan.builds.size(), batch.common.quiet);
  const auto keep = [&](size_t task, const ChildOutcome& outcome) -> Status {
    auto entry = finished(plan.builds[task].entry, outcome);
    if (!entry) return entry.error();
    if (entry->code != 0) {
      rate.clear();
      print_note(entry->name + ": " + entry->message, batch.common.quiet);
    }
    if (Status status = journal.add(*entry); !status) return status;
    rate.count(entry->code != 0);
    entries[entry->name] = std::move(*entry);
    return Done{};
  };
  const PoolOptions options{processes, memory,
                            [&interruption] { return interruption.flag()->load(); }};
  const Status status = run_pool(tasks_of(plan, processes), options, keep);
  rate.clear();
  if (!status) return status.error();
  return rate.seconds();
}

size_t count_failed(const JournalEntries& entries) {
  return std::count_if(entries.begin(), entries.end(),
                       [](const auto& entry) { return entry.second.code != 0; });
}

/// Returns the code of an internal error if there is one, else the highest code.
int worst_code(const JournalEntries& entries) {
  int worst = exit_done;
  for (const auto& [name, entry] : entries) {
    if (entry.code == 1 || entry.code > 128) return 1;
    worst = std::max(worst, entry.code);
  }
  return worst;
}

Status write_text(const fs::path& path, const std::string& text) {
  return write_files({{path, Bytes(text.begin(), text.end())}});
}

Status write_page(const BatchArguments& batch, const JournalEntries& entries) {
  if (!batch.sheet) return Done{};
  const fs::path page = fs::path(batch.output) / "index.html";
  return write_text(page, write_sheet(entries, batch.output));
}

void summarise(const BatchArguments& batch, const JournalEntries& entries, size_t built,
               double seconds) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(),
                ": %zu built in %.1f s, %zu unchanged, %zu failed in total", built, seconds,
                entries.size() - built, count_failed(entries));
  print_result(counted(entries.size(), "drawing") + text.data(), batch.common.quiet);
}

Result<int> build_batch(const BatchArguments& batch, Interruption& interruption) {
  auto work = collect_jobs(batch);
  if (!work) return work.error();
  for (const std::string& line : describe_passed_over(work->passed_over))
    print_note("passed over " + line, batch.common.quiet);
  const fs::path folder = batch.output;
  if (Status status = make_folder(folder); !status) return status.error();
  const std::string shard =
      batch.shards > 1 ? "-" + std::to_string(batch.shard) + "-of-" + std::to_string(batch.shards)
                       : "";
  auto journal = Journal::open(folder / ("journal" + shard + ".jsonl"));
  if (!journal) return journal.error();
  auto entries = read_journals(folder);
  if (!entries) return entries.error();
  const auto plan = plan_batch(batch, std::move(work->jobs), *entries, *interruption.flag());
  if (!plan) return plan.error();
  const auto seconds = build_planned(batch, *plan, *journal, *entries, interruption);
  if (!seconds) return seconds.error();
  std::erase_if(*entries, [&](const auto& entry) { return plan->names.count(entry.first) == 0; });
  if (batch.shards == 1)
    if (Status status = write_page(batch, *entries); !status) return status.error();
  summarise(batch, *entries, plan->builds.size(), *seconds);
  return worst_code(*entries);
}

/// Merges the journals of all shards into one.
Result<int> merge_batch(const BatchArguments& batch) {
  const fs::path folder = batch.output;
  const std::vector<fs::path> paths = journals_in(folder);
  if (paths.empty()) return Error{ErrorCode::file, "contains no journals", folder.string()};
  std::vector<Journal> locked;
  for (const fs::path& path : paths) {
    auto journal = Journal::open(path);
    if (!journal) return journal.error();
    locked.push_back(std::move(*journal));
  }
  const auto entries = read_journals(folder);
  if (!entries) return entries.error();
  std::string text;
  for (const auto& [name, entry] : *entries) text += journal_line(entry);
  const fs::path merged = folder / "journal.jsonl";
  if (Status status = write_text(merged, text); !status) return status.error();
  std::error_code code;
  for (const fs::path& path : paths)
    if (path != merged) fs::remove(path, code);
  if (Status status = write_page(batch, *entries); !status) return status.error();
  summarise(batch, *entries, 0, 0);
  return worst_code(*entries);
}

}  // namespace

Result<int> run_batch(const BatchArguments& batch, Interruption& interruption) {
  return batch.merge ? merge_batch(batch) : build_batch(batch, interruption);
}

}  // namespace relievo::cli

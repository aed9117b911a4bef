#include "apps/cli/batch/batch_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <memory>
#include <sstream>
#include <thread>

#include "apps/cli/batch/passed_over.h"
#include "apps/cli/batch/plan.h"
#include "apps/cli/batch/pool.h"
#include "apps/cli/batch/sheet_page.h"
#include "apps/cli/build_arguments.h"
#include "apps/cli/common_arguments.h"
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

constexpr const char* help =
    R"(Builds many drawings with the same options, several at once, and keeps a journal. Run the same
command again and only drawings that are new, changed or missing their output are built.
A drawing that fails is reported and does not stop the others. Takes the options of build.

Examples:
  relievo batch drawings -o models
  relievo batch *.svg -o models --make glb,normal,depth --vertices 10000 --sheet
  relievo batch sprites.tsv -o models
  relievo batch drawings -o models --shard 3/20
  relievo batch --merge -o models)";

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

/// Counts builds, and shows how many are left and for how long.
class Rate {
 public:
  explicit Rate(size_t all) : all_(all) {}

  void count(bool failed) {
    ++done_;
    failed_ += failed ? 1 : 0;
    const double rate = static_cast<double>(done_) / std::max(seconds(), 1e-3);
    const auto left = std::lround(std::ceil(static_cast<double>(all_ - done_) / rate));
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
                  "%zu of %zu, %zu failed, %.1f a second, %ld:%02ld:%02ld left", done_, all_,
                  failed_, rate, left / 3600, left / 60 % 60, left % 60);
    show_progress(text.data());
  }

  double seconds() const { return watch_.milliseconds() / 1000; }

 private:
  Stopwatch watch_;
  size_t all_;
  size_t done_ = 0;
  size_t failed_ = 0;
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
Result<JournalEntry> finished(JournalEntry entry, const TaskOutcome& outcome) {
  if (outcome.code == exit_code(ErrorCode::interrupted) || outcome.code == 128 + SIGTERM)
    return interrupted_error();
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
  Rate rate(plan.builds.size());
  const auto keep = [&](size_t task, const TaskOutcome& outcome) -> Status {
    auto entry = finished(plan.builds[task].entry, outcome);
    if (!entry) return entry.error();
    if (entry->code != 0) {
      clear_progress();
      print_note(entry->name + ": " + entry->message);
    }
    if (Status status = journal.add(*entry); !status) return status;
    rate.count(entry->code != 0);
    entries[entry->name] = std::move(*entry);
    return Done{};
  };
  const PoolOptions options{processes, memory, *interruption.flag()};
  const Status status = run_pool(tasks_of(plan, processes), options, keep);
  clear_progress();
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
  return write_files({{path, bytes_of(text)}});
}

Status write_page(const BatchArguments& batch, const JournalEntries& entries) {
  if (!batch.sheet) return Done{};
  const fs::path page = fs::path(batch.output) / "index.html";
  return write_text(page, write_sheet(entries, batch.output));
}

void summarise(const JournalEntries& entries, size_t built, double seconds) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(),
                ": %zu built in %.1f s, %zu unchanged, %zu failed in total", built, seconds,
                entries.size() - built, count_failed(entries));
  print_result(counted(entries.size(), "drawing") + text.data());
}

Result<int> build_batch(const BatchArguments& batch, Interruption& interruption) {
  auto work = collect_jobs(batch);
  if (!work) return work.error();
  for (const std::string& line : describe_passed_over(work->passed_over))
    print_note("passed over " + line);
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
  summarise(*entries, plan->builds.size(), *seconds);
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
  summarise(*entries, 0, 0);
  return worst_code(*entries);
}

Result<int> run_batch(const BatchArguments& batch, Interruption& interruption) {
  return batch.merge ? merge_batch(batch) : build_batch(batch, interruption);
}

void set_shard(const std::string& text, BatchArguments& batch) {
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%d/%d%c", &batch.shard, &batch.shards, &rest);
  if (read != 2 || batch.shards < 1 || batch.shard < 1 || batch.shard > batch.shards)
    throw CLI::ValidationError("--shard " + text, "must be of the form 3/20, from 1/20 to 20/20");
}

void add_work(CLI::App& app, BatchArguments& batch) {
  app.add_option("--jobs", batch.jobs,
                 "Number of drawings to build at once (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  app.add_option("--memory", batch.memory_mb,
                 "Memory for all of them together in MB (default: 80 % of the free memory)")
      ->check(CLI::Range(200.0, 1e7));
  app.add_option_function<std::string>(
      "--shard", [&batch](const std::string& text) { set_shard(text, batch); },
      "Builds only the Kth of N shares, given as K/N, with a journal of its own");
  app.add_flag("--retry", batch.retry, "Builds failed drawings again");
  app.add_flag("--sheet", batch.sheet, "Makes a contact sheet, index.html, and its pictures");
  app.add_flag("--merge", batch.merge,
               "Merges the journals of all shards into one, and builds nothing");
  app.add_flag("-q,--quiet", batch.common.quiet, "Print errors only");
}

/// Copies the options of `build` that were given to `group`. Throws CLI::ValidationError if options
/// contradict each other.
void settle_batch(const CLI::App& group, BatchArguments& batch) {
  if (batch.merge == !batch.inputs.empty())
    throw CLI::ValidationError(batch.merge ? "--merge takes no drawings"
                                           : "no drawings: give files, folders or tables");
  for (const CLI::Option* option : group.get_options()) {
    const std::vector<std::string>& values = option->results();
    const bool flag = option->get_expected_max() == 0;
    const int each = flag ? 1 : option->get_expected_min();
    for (auto value = values.begin(); value != values.end(); value += each) {
      batch.words.push_back("--" + option->get_single_name());
      if (!flag) batch.words.insert(batch.words.end(), value, value + each);
    }
  }
}

}  // namespace

void add_batch(CLI::App& main, Command& chosen) {
  const auto batch = std::make_shared<BatchArguments>();
  CLI::App& app = *main.add_subcommand("batch", help);
  app.add_option("INPUT", batch->inputs,
                 "Drawings, folders to search for drawings, or tables of drawings (.tsv)");
  app.add_option("-o,--output", batch->output, "Output folder")->required();
  app.add_option(
         "--make", batch->make,
         "Outputs for each drawing, separated by commas: glb (the default), obj, ply, stl, 3mf, "
         "usdz, html, normal, depth, part, occlusion, preview, overlay, report")
      ->delimiter(',')
      ->check(CLI::IsMember({"glb", "obj", "ply", "stl", "3mf", "usdz", "html", "normal", "depth",
                             "part", "occlusion", "preview", "overlay", "report"}));
  add_work(app, *batch);
  // The builds parse these options again; here they are only checked.
  const auto choices = std::make_shared<BuildArguments>();
  CLI::App& group = *app.add_option_group("Each drawing");
  group
      .add_option("--timeout", choices->common.timeout,
                  "Give up on a drawing after this many seconds")
      ->check(CLI::PositiveNumber);
  add_build_choices(group, *choices);
  app.callback([batch, choices, &group, &chosen] {
    settle_batch(group, *batch);
    chosen = command(batch, run_batch);
  });
}

}  // namespace relievo::cli

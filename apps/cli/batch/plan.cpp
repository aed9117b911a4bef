#include "apps/cli/batch/plan.h"

#include <algorithm>
#include <filesystem>

#include "apps/cli/batch/digest.h"
#include "relievo/run_context.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

bool all_there(const std::vector<std::string>& files) {
  std::error_code code;
  return std::all_of(files.begin(), files.end(),
                     [&](const std::string& file) { return fs::is_regular_file(file, code); });
}

/// Whether what the journal says of a drawing still holds.
bool holds(const JournalEntry& known, const JournalEntry& wanted, bool retry) {
  const bool same = known.digest == wanted.digest && known.options == wanted.options &&
                    known.version == wanted.version && known.input == wanted.input;
  return same && (known.code == 0 ? all_there(wanted.files) : !retry);
}

JournalEntry entry_of(const BatchJob& job) {
  JournalEntry entry;
  entry.name = job.name;
  entry.input = job.input.string();
  entry.options = job.words;
  entry.version = RELIEVO_VERSION;
  for (const fs::path& file : job.outputs) entry.files.push_back(file.string());
  // The build says why a drawing cannot be read.
  if (auto digest = digest_of(job.input)) entry.digest = std::move(*digest);
  return entry;
}

}  // namespace

Result<BatchPlan> plan_batch(const BatchArguments& batch, std::vector<BatchJob> jobs,
                             const JournalEntries& known, const std::atomic<bool>& stop) {
  BatchPlan plan;
  for (size_t k = 0; k < jobs.size(); ++k) {
    if (static_cast<int>(k % batch.shard.count) != batch.shard.index - 1) continue;
    if (stop) return interrupted_error();
    BatchJob& job = jobs[k];
    plan.names.insert(job.name);
    JournalEntry entry = entry_of(job);
    const auto before = known.find(job.name);
    if (before != known.end() && holds(before->second, entry, batch.retry)) continue;
    plan.builds.push_back({std::move(job), std::move(entry)});
  }
  return plan;
}

}  // namespace relievo::cli

#include "apps/cli/batch/plan.h"

#include <algorithm>
#include <filesystem>

#include "apps/cli/batch/digest.h"
#include "relievo/run_context.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

bool all_exist(const std::vector<std::string>& files) {
  std::error_code code;
  return std::all_of(files.begin(), files.end(),
                     [&](const std::string& file) { return fs::is_regular_file(file, code); });
}

/// Checks whether the journal entry of a drawing is up to date.
bool is_current(const JournalEntry& known, const JournalEntry& wanted, bool retry) {
  const bool same = known.digest == wanted.digest && known.options == wanted.options &&
                    known.version == wanted.version && known.input == wanted.input;
  return same && (known.code == 0 ? all_exist(wanted.files) : !retry);
}

}  // namespace

Result<BatchPlan> plan_batch(const BatchArguments& batch, std::vector<BatchJob> jobs,
                             const JournalEntries& known, const std::atomic<bool>& stop) {
  BatchPlan plan;
  for (size_t k = 0; k < jobs.size(); ++k) {
    if (static_cast<int>(k % batch.shards) != batch.shard - 1) continue;
    if (stop) return interrupted_error();
    JournalEntry& entry = jobs[k].entry;
    plan.names.insert(entry.name);
    // The build reports why a drawing cannot be read.
    if (auto digest = digest_of(entry.input)) entry.digest = std::move(*digest);
    const auto before = known.find(entry.name);
    if (before != known.end() && is_current(before->second, entry, batch.retry)) continue;
    plan.builds.push_back(std::move(jobs[k]));
  }
  return plan;
}

}  // namespace relievo::cli

#pragma once

#include <atomic>
#include <set>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "apps/cli/batch/jobs.h"
#include "apps/cli/batch/journal.h"

namespace relievo::cli {

struct BatchPlan {
  std::set<std::string> names;   ///< of all drawings of the batch, or of its shard
  std::vector<BatchJob> builds;  ///< new, changed or without their outputs, sorted by name
};

/// Selects the builds of a batch that are still to do: drawings without a journal entry, with other
/// content, options or program than in their entry, or without their outputs; and failed ones if
/// `batch.retry`. Reads every drawing once. `jobs` are those of collect_jobs. Errors:
/// `interrupted`.
Result<BatchPlan> plan_batch(const BatchArguments& batch, std::vector<BatchJob> jobs,
                             const JournalEntries& known, const std::atomic<bool>& stop);

}  // namespace relievo::cli

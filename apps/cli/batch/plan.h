#pragma once

#include <atomic>
#include <set>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "apps/cli/batch/jobs.h"
#include "apps/cli/batch/journal.h"

namespace relievo::cli {

/// A drawing that is to be built, and its line of the journal as far as that is known before.
struct PlannedBuild {
  BatchJob job;
  JournalEntry entry;
};

struct BatchPlan {
  std::set<std::string> names;       ///< of all drawings of the batch, or of its shard
  std::vector<PlannedBuild> builds;  ///< those that are missing or changed, in the order of names
};

/// What is left to do of a batch: drawings without an entry, whose content, options or program are
/// others than those of their entry, or whose results are gone; failed ones too where they are to
/// be tried again. Reads every drawing once. `jobs`: all of the batch, as
/// collect_jobs has them. Errors: `interrupted`.
Result<BatchPlan> plan_batch(const BatchArguments& batch, std::vector<BatchJob> jobs,
                             const JournalEntries& known, const std::atomic<bool>& stop);

}  // namespace relievo::cli

#pragma once

#include <filesystem>
#include <vector>

#include "apps/cli/arguments.h"
#include "apps/cli/batch/journal.h"
#include "relievo/result.h"

namespace relievo::cli {

/// The build of one drawing.
struct BatchJob {
  JournalEntry entry;  ///< with the fields that are known before the build
  int vertices = 0;    ///< approximate number
};

/// The jobs of a batch, and the files that it passes over.
struct BatchWork {
  std::vector<BatchJob> jobs;                      ///< sorted by name
  std::vector<std::filesystem::path> passed_over;  ///< files in folders that are no drawings
};

/// Returns the builds of a batch: of the drawings given, those in folders and below, and those in
/// tables. A folder of layers is one drawing. Drawings of the same name get their extensions
/// appended. Errors: `usage` for a wrong option in a table, `bad_input` for a table, with its line,
/// `file` if something cannot be read.
Result<BatchWork> collect_jobs(const BatchArguments& batch);

}  // namespace relievo::cli

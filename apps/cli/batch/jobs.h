#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "relievo/result.h"

namespace relievo::cli {

/// One drawing of a batch.
struct BatchJob {
  std::filesystem::path input;
  std::string name;                            ///< of its outputs, relative to their folder
  std::vector<std::string> words;              ///< options of its `build`, outputs included
  std::vector<std::filesystem::path> outputs;  ///< what these write
  int vertices = 0;                            ///< about so many will be made
};

/// The drawings of a batch in the order of their names: those given, those in folders and below,
/// and those that manifests name. A folder of layers is one drawing. Two of one name get their
/// extensions into it.
/// Errors: `usage` where an option of a row is wrong, `bad_input` for a manifest, naming its line,
/// `file` where something cannot be read.
Result<std::vector<BatchJob>> collect_jobs(const BatchArguments& batch);

}  // namespace relievo::cli

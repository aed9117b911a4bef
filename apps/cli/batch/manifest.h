#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "relievo/result.h"

namespace relievo::cli {

struct ManifestRow {
  int line = 0;  ///< in the file, from 1
  std::filesystem::path input;
  std::string name;                ///< empty: that of the input
  std::vector<std::string> words;  ///< options of `build`
};

/// A table of drawings: lines of cells between tabs, the first one names the columns. `input` is a
/// path from the manifest's folder, `name` that of the outputs, and each other column an option of
/// `build` without its dashes; empty cells say nothing, `yes` sets an option that takes no value,
/// and values of an option that takes several are between blanks. Lines that are empty or begin
/// with # are passed over.
/// Errors: `file`; `bad_input`, `where` is the file and the line.
Result<std::vector<ManifestRow>> read_manifest(const std::filesystem::path& path);

}  // namespace relievo::cli

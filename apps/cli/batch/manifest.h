#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "relievo/result.h"

namespace relievo::cli {

/// A drawing of a batch.
struct ListedDrawing {
  std::filesystem::path input;
  std::filesystem::path name;  ///< of its outputs: as in the table, or the input's with extension
  bool named = false;          ///< whether a table gives the name
  std::vector<std::string> words;  ///< options of `build` for this drawing
  std::string where;               ///< file and line of a table; empty: none
};

/// Reads a table of drawings: lines of cells separated by tabs. The first line names the columns:
/// `input`, a path relative to the table's folder; `name`, that of the outputs; and options of
/// `build` without their dashes. An empty cell leaves an option out, `yes` sets an option without a
/// value, and several values are separated by blanks. Lines that are empty or begin with # are
/// ignored. Errors: `file`; `bad_input`, whose `where` is the file and the line.
Result<std::vector<ListedDrawing>> read_manifest(const std::filesystem::path& path);

}  // namespace relievo::cli

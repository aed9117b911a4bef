#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "relievo/result.h"

namespace relievo {

/// Returns the path relative to the folder, links followed on both sides; nothing where it is not
/// below the folder or cannot be resolved.
std::optional<std::filesystem::path> path_below(const std::filesystem::path& path,
                                                const std::filesystem::path& folder);

/// Returns the error with the file's name at the beginning of `where`.
inline Error in_file(Error error, const std::string& name) {
  if (error.where.rfind(name, 0) != 0)
    error.where = error.where.empty() ? name : name + ": " + error.where;
  return error;
}

}  // namespace relievo

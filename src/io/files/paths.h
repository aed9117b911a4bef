#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "relievo/result.h"

namespace relievo {

/// The path as seen from the folder, links followed on both sides; nothing where it is not below
/// the folder or cannot be told.
std::optional<std::filesystem::path> path_below(const std::filesystem::path& path,
                                                const std::filesystem::path& folder);

/// The error with a file's name in front of where it is, unless that begins with it already.
inline Error in_file(Error error, const std::string& name) {
  if (error.where.rfind(name, 0) != 0)
    error.where = error.where.empty() ? name : name + ": " + error.where;
  return error;
}

}  // namespace relievo

#pragma once

#include <filesystem>
#include <optional>

namespace relievo {

/// The path as seen from the folder, links followed on both sides; nothing where it is not below
/// the folder or cannot be told.
std::optional<std::filesystem::path> path_below(const std::filesystem::path& path,
                                                const std::filesystem::path& folder);

}  // namespace relievo

#include "io/files/paths.h"

namespace relievo {

namespace fs = std::filesystem;

std::optional<fs::path> path_below(const fs::path& path, const fs::path& folder) {
  const auto resolved = [](const fs::path& any) -> std::optional<fs::path> {
    std::error_code code;
    const fs::path absolute = fs::absolute(any, code);
    if (code) return std::nullopt;
    const fs::path canonical = fs::weakly_canonical(absolute, code);
    return code ? std::nullopt : std::optional(canonical);
  };
  const auto from = resolved(folder);
  const auto to = resolved(path);
  if (!from || !to) return std::nullopt;
  const fs::path inside = to->lexically_relative(*from);
  if (inside.empty() || *inside.begin() == "..") return std::nullopt;
  return inside;
}

}  // namespace relievo

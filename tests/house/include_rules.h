#pragma once

#include <string>

namespace relievo::house {

/// Why the file at `from` must not include `to`; empty where it may. Paths are as in an include:
/// relative to src/ ("kernel/base/workers.h"), or to the repository for apps/, tests/, ...
std::string include_violation(const std::string& from, const std::string& to);

/// What a source file says that the conventions forbid, one finding a line; empty where it is fine.
std::string text_violations(const std::string& path, const std::string& text);

}  // namespace relievo::house

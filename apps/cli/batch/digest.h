#pragma once

#include <filesystem>
#include <string>

#include "relievo/result.h"

namespace relievo::cli {

/// SHA-256, in hexadecimal digits, of what a drawing's results depend on: the file and the drawing
/// that a scene names, or the files of a folder with their names. Errors: `file`, `limit`.
Result<std::string> digest_of(const std::filesystem::path& input);

}  // namespace relievo::cli

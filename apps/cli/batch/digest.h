#pragma once

#include <filesystem>
#include <string>

#include "relievo/result.h"

namespace relievo::cli {

/// Returns the SHA-256 of an input, in hexadecimal digits: of the file and the drawing that a scene
/// names, or of the files of a folder with their names. Errors: `file`, `limit`.
Result<std::string> digest_of(const std::filesystem::path& input);

}  // namespace relievo::cli

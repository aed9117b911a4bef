#pragma once

#include <string>

namespace relievo::cli {

/// Returns the text of --version: "relievo 1.2.3", then the revision, the compiler and the
/// libraries.
std::string version_text();

}  // namespace relievo::cli

#pragma once

#include <string>

namespace relievo::cli {

/// What --version prints: "relievo 1.2.3", then a line each on how it was built and with what.
std::string version_text();

}  // namespace relievo::cli

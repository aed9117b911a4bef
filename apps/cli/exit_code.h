#pragma once

#include "relievo/result.h"

namespace relievo::cli {

constexpr int exit_done = 0;

/// The exit codes of the kinds of failure, in the order of ErrorCode.
constexpr int exit_codes[] = {1, 2, 3, 4, 5, 6, 130};

constexpr int exit_code(ErrorCode code) { return exit_codes[static_cast<int>(code)]; }

}  // namespace relievo::cli

#pragma once

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Runs the command that `parse` finds in the arguments, and returns the exit code of the process.
/// Prints errors, exceptions among them, on standard error.
int run_program(int argc, const char* const* argv,
                ParsedArguments (*parse)(int argc, const char* const* argv));

}  // namespace relievo::cli

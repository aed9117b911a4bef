#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds the command `segment`, which becomes `chosen` if the command line names it.
void add_segment(CLI::App& main, Command& chosen);

}  // namespace relievo::cli

#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds the command `render`, which becomes `chosen` if the command line names it.
void add_render(CLI::App& main, Command& chosen);

}  // namespace relievo::cli

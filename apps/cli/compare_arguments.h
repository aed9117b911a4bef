#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds the command.
void add_compare(CLI::App& main, CompareArguments& compare);

/// Throws CLI::ValidationError where no output is asked for.
void settle_compare(const CompareArguments& compare);

}  // namespace relievo::cli

#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds the command `sequence`.
void add_sequence(CLI::App& main, SequenceArguments& sequence);

}  // namespace relievo::cli

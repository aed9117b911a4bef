#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds the command. `choices` takes the options that are those of `build` and is of no further
/// use.
CLI::App& add_batch(CLI::App& main, BatchArguments& batch, BuildArguments& choices);

/// Takes over the options of `build` that were given to `app`, the command. Throws
/// CLI::ValidationError where options contradict each other.
void settle_batch(const CLI::App& app, BatchArguments& batch);

}  // namespace relievo::cli

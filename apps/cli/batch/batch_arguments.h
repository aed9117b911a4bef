#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds the command `batch`. `choices` receives the options of `build`, and must live until the
/// arguments are parsed.
CLI::App& add_batch(CLI::App& main, BatchArguments& batch, BuildArguments& choices);

/// Copies the options of `build` that were given to `app`, the command, to `batch`. Throws
/// CLI::ValidationError if options contradict each other.
void settle_batch(const CLI::App& app, BatchArguments& batch);

}  // namespace relievo::cli

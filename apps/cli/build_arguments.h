#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Adds the command.
void add_build(CLI::App& main, BuildArguments& build);

/// Adds how a drawing is built: all options but its input and outputs.
void add_build_choices(CLI::App& app, BuildArguments& build);

/// Throws CLI::ValidationError where options contradict each other.
void settle_build(const BuildArguments& build);

/// What `relievo build INPUT WORDS...` would do. Errors: `usage`.
Result<BuildArguments> parse_build(const std::string& input, const std::vector<std::string>& words);

}  // namespace relievo::cli

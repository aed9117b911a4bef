#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Adds the command `build`, which becomes `chosen` if the command line names it.
void add_build(CLI::App& main, Command& chosen);

/// Adds all options of `build` except its input and outputs.
void add_build_choices(CLI::App& app, BuildArguments& build);

/// Parses the arguments of `relievo build INPUT WORDS...`. Errors: `usage`.
Result<BuildArguments> parse_build(const std::string& input, const std::vector<std::string>& words);

}  // namespace relievo::cli
